#include <gmock/gmock.h>

#include "base/error.h"
#include "base/file.h"
#include "tests/server/cli/cli_fixture.h"

namespace lares::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

TEST_F(CliTest, ARecipeIsPutListedReadAndRemoved) {
  const auto file = Write("search.ttl", kTurtle);
  const Outcome put = Lares({"recipe", "put", file});
  EXPECT_EQ(put.code, 0) << put.err;
  EXPECT_THAT(put.out, AllOf(StartsWith("recipe search, version 1: "),
                             HasSubstr("task urn:x 'FindBottle' (1 step, state-machine)"),
                             HasSubstr("warnings:\n  'urn:absent'")));
  EXPECT_THAT(Lares({"recipe", "list"}).out,
              AllOf(HasSubstr("ID"), HasSubstr("search"), HasSubstr("Label of search")));
  EXPECT_EQ(Lares({"recipe", "get", "search"}).out, kTurtle);
  Lares({"recipe", "get", "search", "--out", (folder_ / "copy.ttl").string()});
  EXPECT_EQ(ReadFile(folder_ / "copy.ttl"), kTurtle);
  EXPECT_EQ(Lares({"recipe", "remove", "search"}).code, 0);
  EXPECT_EQ(Lares({"recipe", "list"}).out, "no recipe is stored\n");
  EXPECT_EQ(Lares({"recipe", "remove", "search"}).code, 4);
}

TEST_F(CliTest, ARefusalNamesThePlaceAndTheWayOut) {
  const auto file = Write("exploration-recipe.owl", "malformed");
  const Outcome refused = Lares({"recipe", "put", file});
  EXPECT_EQ(refused.code, 3);
  EXPECT_EQ(refused.err,
            "lares: exploration-recipe.owl:715:6: malformed comment\n"
            "hint: --recover repairs this and lists what it did\n");
  const Outcome recovered = Lares({"recipe", "put", "--recover", file});
  EXPECT_EQ(recovered.code, 0);
  EXPECT_THAT(recovered.out, HasSubstr("repaired (the original is kept):\n"
                                       "  exploration-recipe.owl:715:6: comment mended\n"));
}

TEST_F(CliTest, OntologiesAreConvertedAndMergedWithoutAServer) {
  url_ = "http://127.0.0.1:1";
  const auto first = Write("a.owl",
                           "Prefix(:=<http://e/>)\nOntology(<http://e/o> Import(<http://e/q>)\n"
                           "SubClassOf(:A :B))");
  const auto second = Write("b.ttl",
                            "@prefix : <http://e/> . :q a <http://www.w3.org/2002/07/owl#Ontology> "
                            ". :B <http://www.w3.org/2000/01/rdf-schema#subClassOf> :C .");
  const auto merged = (folder_ / "merged.owx").string();
  const Outcome xml =
      Lares({"ontology", "convert", first, second, "--to", "owl-xml", "-o", merged});
  EXPECT_EQ(xml.code, 0) << xml.err;
  EXPECT_EQ(Lares({"ontology", "convert", merged, "--to", "owl-functional"}).out,
            "Prefix(:=<http://e/>)\n\nOntology(<http://e/o>\nSubClassOf(:A :B)\n"
            "SubClassOf(:B :C)\n)\n");
  EXPECT_EQ(Lares({"ontology", "convert", first, "--to", "manchester"}).code, 2);
  EXPECT_EQ(Lares({"ontology", "convert", "absent.owl", "--to", "turtle"}).code, 2);
}

TEST_F(CliTest, TriplesOfNoAxiomAreRefusedOrLeftOutByName) {
  const auto file =
      Write("a.ttl",
            "@prefix : <http://e/> . @prefix rdf: "
            "<http://www.w3.org/1999/02/22-rdf-syntax-ns#> . :a rdf:value 1 ; a :A .");
  const Outcome refused = Lares({"ontology", "convert", file, "--to", "owl-functional"});
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, HasSubstr("lares: no axiom of OWL 2 says <http://e/a>"));
  const Outcome told =
      Lares({"ontology", "convert", file, "--to", "owl-functional", "--leave-out"});
  EXPECT_EQ(told.code, 0);
  EXPECT_THAT(told.out, HasSubstr("ClassAssertion(:A :a)"));
  EXPECT_THAT(told.err, StartsWith("left out: <http://e/a> "));
}

TEST_F(CliTest, SeveralFilesGoOnAfterARefusal) {
  const auto bad = Write("bad.owl", "malformed");
  const auto good = Write("good.owl", "fine");
  const Outcome outcome = Lares({"robot", "put", bad, good});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.out, HasSubstr("robot good"));
  EXPECT_EQ(Lares({"robot", "put", "--id", "x", bad, good}).code, 2);
}

TEST_F(CliTest, IdsThatAreNoneAreRefusedBeforeAnythingIsSent) {
  const auto file = Write("my file.owl", "fine");
  const Outcome refused = Lares({"recipe", "put", file});
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, HasSubstr("give one with --id"));
  EXPECT_EQ(Lares({"recipe", "put", "--id", "mine", file}).code, 0);
}

TEST_F(CliTest, JsonIsWhatTheServerSaid) {
  const auto file = Write("search.ttl", kTurtle);
  EXPECT_EQ(nlohmann::json::parse(Lares({"recipe", "put", file, "--json"}).out)["document"]["id"],
            "search");
  EXPECT_EQ(nlohmann::json::parse(Lares({"--json", "recipe", "list"}).out)["count"], 1);
  const Outcome refused = Lares({"--json", "recipe", "get", "nobody"});
  EXPECT_EQ(refused.code, 4);
  EXPECT_EQ(nlohmann::json::parse(refused.out)["code"], "not-found");
}

TEST_F(CliTest, PlansArePrintedOrSaved) {
  EXPECT_EQ(Lares({"plan", "FindBottle", "--robot", "pioneer"}).out, "plan of FindBottle\n");
  EXPECT_EQ(Lares({"plan", "FindBottle", "--robot", "p", "--as", "dot"}).out, "digraph {}\n");
  const auto file = folder_ / "plan.xml";
  Lares({"plan", "FindBottle", "--robot", "p", "--as", "bt-xml", "--out", file.string()});
  EXPECT_EQ(ReadFile(file), "<root task=\"FindBottle\"/>");
  EXPECT_EQ(Lares({"plan", "FindBottle", "--robot", "p", "--as", "poem"}).code, 2);
  EXPECT_EQ(Lares({"plan", "FindBottle"}).code, 2);
}

TEST_F(CliTest, AnswersToChoicesReachThePlanner) {
  server::PlanRequest seen;
  Answers().plan = [&](const server::PlanRequest& request) {
    seen = request;
    server::PlanAnswer answer;
    answer.result.plan = recipes::Plan{};
    return answer;
  };
  Lares({"plan", "T", "--robot", "R", "--environment", "E", "--version", "2", "--strict",
         "--template", "urn:a=b=urn:t", "--template", "Grasp=Top"});
  EXPECT_EQ(seen.environment, "E");
  EXPECT_EQ(seen.environment_version, 2);
  EXPECT_TRUE(seen.strict);
  EXPECT_EQ(seen.templates.at("urn:a=b"), "urn:t");
  EXPECT_EQ(seen.templates.at("Grasp"), "Top");
  EXPECT_EQ(Lares({"plan", "T", "--robot", "R", "--template", "nonsense"}).code, 2);
}

TEST_F(CliTest, NoPlanIsExplainedAndHasItsOwnExitCode) {
  Answers().plan = [](const server::PlanRequest&) {
    server::PlanAnswer answer;
    answer.result.match.task = {"urn:t", "ServeADrink", ""};
    answer.result.match.robot = {"urn:p", "Pioneer", ""};
    answer.result.match.smallest_repair = {{"urn:Arm", "ArmComponent", ""}};
    answer.capable_robots = {{"urn:a", "AMIGO", ""}};
    return answer;
  };
  const Outcome no = Lares({"plan", "ServeADrink", "--robot", "pioneer"});
  EXPECT_EQ(no.code, 7);
  EXPECT_THAT(no.out, AllOf(HasSubstr("ServeADrink needs more\n"), HasSubstr("AMIGO")));
  EXPECT_THAT(no.err, HasSubstr("Pioneer cannot do ServeADrink; it lacks ArmComponent"));
}

TEST_F(CliTest, RobotsOfARecipeAreATableOfWhatTheyLack) {
  const Outcome robots = Lares({"recipe", "robots", "FindBottle", "--environment", "flat"});
  EXPECT_EQ(robots.code, 0);
  EXPECT_THAT(robots.out, AllOf(StartsWith("ROBOT   CAN  COST  CHANGE\n"),
                                HasSubstr("rover   yes  0.1   downloads map\n"),
                                HasSubstr("statue  no   200   add base with a max speed\n"),
                                HasSubstr("stone   no   -     nothing that could be added")));
}

TEST_F(CliTest, AmbiguousNamesAreListed) {
  Answers().plan = [](const server::PlanRequest&) -> server::PlanAnswer {
    throw Error(Code::kAmbiguous, "'amigo' means several things")
        .WithCandidates({"amigo", "amigo2"});
  };
  const Outcome ambiguous = Lares({"plan", "T", "--robot", "amigo"});
  EXPECT_EQ(ambiguous.code, 4);
  EXPECT_THAT(ambiguous.err, HasSubstr("did you mean:\n  amigo\n  amigo2\n"));
}

TEST_F(CliTest, LikelyPlacesAreRankedForPeople) {
  const Outcome where = Lares({"where", "Cup", "--prior", "omics", "--environment", "lab"});
  EXPECT_EQ(where.code, 0);
  EXPECT_THAT(
      where.out,
      AllOf(StartsWith("seen: bottle1 at (1.00, 2.00, 3.00) m in lab version 1, just now\n"),
            HasSubstr("by table 'omics' (Where things are)\n"), HasSubstr("  Kitchen   72.8 %\n"),
            HasSubstr("  Office    16.1 %\n")));
}

TEST_F(CliTest, PriorsAreNamedAfterTheirFormatOrFile) {
  const auto omics = Write("locations.rdf", "x");
  const auto tsv = Write("home.tsv", "x");
  EXPECT_THAT(Lares({"prior", "import", omics, "--format", "omics"}).out,
              StartsWith("prior omics, version 1"));
  EXPECT_THAT(Lares({"prior", "import", tsv, "--format", "tsv"}).out, StartsWith("prior home,"));
  EXPECT_THAT(Lares({"prior", "import", tsv, "--format", "tsv", "--name", "mine"}).out,
              StartsWith("prior mine,"));
  EXPECT_EQ(Lares({"prior", "import", tsv, "--format", "csv"}).code, 2);
  EXPECT_THAT(Lares({"prior", "list"}).out, AllOf(HasSubstr("omics"), HasSubstr("home.tsv")));
}

TEST_F(CliTest, OntologyAndStatusAreShown) {
  EXPECT_THAT(Lares({"ontology", "list"}).out, AllOf(HasSubstr("core"), HasSubstr("built-in")));
  EXPECT_THAT(Lares({"ontology", "aliases"}).out, HasSubstr("http://old#"));
  EXPECT_THAT(Lares({"status"}).out, HasSubstr("statements inferred  30"));
  EXPECT_THAT(Lares({"version"}).out, StartsWith("lares "));
}

TEST_F(CliTest, AnObjectModelGoesThereAndBack) {
  const auto description = Write("cabinet.ttl", kTurtle);
  const auto photo = Write("face.png", "pixels");
  EXPECT_EQ(Lares({"object-model", "put", photo, description, "--id", "cabinet1"}).code, 0);
  EXPECT_THAT(Lares({"object-model", "list", "--class", "Cabinet"}).out, HasSubstr("cabinet1"));
  EXPECT_EQ(Lares({"object-model", "put", photo}).code, 3);
  const auto out = folder_ / "model";
  EXPECT_EQ(Lares({"object-model", "get", "cabinet1", "--out", out.string()}).code, 0);
  EXPECT_EQ(ReadFile(out / "cabinet.ttl"), kTurtle);
  EXPECT_EQ(ReadFile(out / "face.png"), "pixels");
}

TEST_F(CliTest, TypicalObjectModelsAreShownAndDownloaded) {
  const auto description = Write("cabinet.ttl", kTurtle);
  const auto photo = Write("face.png", "pixels");
  EXPECT_EQ(Lares({"object-model", "put", photo, description, "--id", "cabinet1"}).code, 0);
  EXPECT_EQ(Lares({"object-model", "put", description, "--id", "cabinet2"}).code, 0);
  const auto out = folder_ / "models";
  const Outcome typical =
      Lares({"object-model", "typical", "Office", "--max-models", "1", "--download", out.string()});
  EXPECT_EQ(typical.code, 0) << typical.err;
  EXPECT_THAT(typical.out, AllOf(HasSubstr("for Office, by table 'lares': 1 model"),
                                 HasSubstr("cabinet1  25.0 %"), HasSubstr("because"),
                                 HasSubstr("left out:\n  cabinet2")));
  EXPECT_EQ(ReadFile(out / "cabinet1/cabinet.ttl"), kTurtle);
  EXPECT_EQ(ReadFile(out / "cabinet1/face.png"), "pixels");
  EXPECT_FALSE(std::filesystem::exists(out / "cabinet2"));
  EXPECT_THAT(ReadFile(out / "typical.json"), HasSubstr("\"loaded\""));
  // A folder with other things in it stays as it is.
  EXPECT_NE(Lares({"object-model", "typical", "Office", "--download", out.string()}).code, 0);
  EXPECT_EQ(ReadFile(out / "cabinet1/face.png"), "pixels");
  EXPECT_EQ(Lares({"object-model", "typical"}).code, 2);
  EXPECT_EQ(Lares({"object-model", "typical", "Office", "--robot", "nobody"}).code, 4);
  EXPECT_THAT(Lares({"object-model", "list", "--room", "Office", "--class", "Cabinet"}).out,
              AllOf(HasSubstr("25.0 %"), HasSubstr("0.4 × 0.8 × 0.6 m")));
  EXPECT_THAT(Lares({"object-model", "list", "--class", "Bottle"}).out,
              HasSubstr("no stored object model is like that"));
}

TEST_F(CliTest, WithoutAServerItSaysHowToStartOne) {
  server_.reset();
  url_ = "http://127.0.0.1:1";
  const Outcome outcome = Lares({"recipe", "list"});
  EXPECT_EQ(outcome.code, 6);
  EXPECT_EQ(outcome.err,
            "lares: no Lares server answers at http://127.0.0.1:1; start one with: "
            "lares serve (or ./start)\n");
}

TEST_F(CliTest, MissingFilesAndUnknownWordsFailWithTheirCodes) {
  EXPECT_EQ(Lares({"recipe", "put", "/no/such/file.owl"}).code, 1);
  EXPECT_EQ(Lares({"recipe", "put", folder_.string()}).code, 1);
  EXPECT_EQ(Lares({"dance"}).code, 2);
  EXPECT_EQ(Lares({}).code, 2);
  EXPECT_EQ(Lares({"recipe"}).code, 2);
  url_ = "ftp://nowhere";
  EXPECT_EQ(Lares({"recipe", "list"}).code, 2);
}

TEST_F(CliTest, EveryCommandHasHelpWithExamples) {
  const std::vector<std::vector<std::string>> commands{{"serve"},
                                                       {"recipe", "put"},
                                                       {"recipe", "list"},
                                                       {"recipe", "get"},
                                                       {"recipe", "remove"},
                                                       {"robot", "put"},
                                                       {"ontology", "put"},
                                                       {"ontology", "aliases"},
                                                       {"ontology", "check"},
                                                       {"environment", "put"},
                                                       {"environment", "get"},
                                                       {"environment", "list"},
                                                       {"environment", "log"},
                                                       {"object-model", "put"},
                                                       {"object-model", "list"},
                                                       {"object-model", "get"},
                                                       {"object-model", "typical"},
                                                       {"plan"},
                                                       {"prior", "import"},
                                                       {"prior", "list"},
                                                       {"where"},
                                                       {"status"},
                                                       {"version"},
                                                       {"help"}};
  for (std::vector<std::string> command : commands) {
    const std::string name = command.back();
    command.push_back("--help");
    const Outcome help = Lares(command);
    EXPECT_EQ(help.code, 0) << name;
    EXPECT_THAT(help.out, HasSubstr("Examples:\n  lares ")) << name;
    EXPECT_THAT(help.err, IsEmpty()) << name;
  }
}

TEST_F(CliTest, CheckNamesEachFindingsPlaceAndEndsWithACodeOfItsOwn) {
  const std::string good = Write("good.ttl", kTurtle).string();
  const std::string bad = Write("bad.ttl", "bad").string();
  const Outcome clean = Lares({"ontology", "check", good});
  EXPECT_EQ(clean.code, 0) << clean.err;
  EXPECT_THAT(clean.out, HasSubstr("good.ttl: 26 statements, OWL 2 RL, clean\n"));
  const Outcome found = Lares({"ontology", "check", bad});
  EXPECT_EQ(found.code, 9);
  EXPECT_THAT(found.out, HasSubstr(bad + ":3:5: profile: owl:unionOf on the side of the superclass "
                                         "(Cup, Mug; 7 places, also 9:1)\n"));
  EXPECT_THAT(found.out, HasSubstr(bad + ":4:1: remark: punning (A)\n"));
  EXPECT_THAT(found.out, HasSubstr("not OWL 2 RL\n"));
  EXPECT_THAT(found.err, HasSubstr("bad.ttl is not clean"));
  const Outcome both = Lares({"ontology", "check", good, bad});
  EXPECT_EQ(both.code, 9);
  EXPECT_THAT(both.err, HasSubstr("1 of 2 files are not clean"));
  const Outcome json = Lares({"ontology", "check", "--json", bad});
  EXPECT_EQ(json.code, 9);
  EXPECT_EQ(nlohmann::json::parse(json.out)["findings"][0]["count"], 7);
  EXPECT_EQ(Lares({"ontology", "check"}).code, 2);
  EXPECT_EQ(Lares({"ontology", "check", (folder_ / "absent.ttl").string()}).code, 1);
}

TEST_F(CliTest, ServeRefusesToFaceTheNetwork) {
  const Outcome refused = Lares({"serve", "--host", "0.0.0.0", "--port", "0", "--data",
                                 (folder_ / "other").string(), "--log-level", "off"});
  EXPECT_EQ(refused.code, 3);
  EXPECT_EQ(Lares({"serve", "--data", ""}).code, 2);
  EXPECT_EQ(Lares({"serve", "--log-level", "loud"}).code, 2);
  EXPECT_THAT(refused.err, HasSubstr("'0.0.0.0' is not this machine's loopback"));
}

TEST_F(CliTest, ServeSaysWhenThePortIsTaken) {
  const std::string port = server_->url().substr(server_->url().rfind(':') + 1);
  const Outcome taken = Lares(
      {"serve", "--port", port, "--data", (folder_ / "other").string(), "--log-level", "off"});
  EXPECT_EQ(taken.code, 5);
  EXPECT_THAT(taken.err, HasSubstr("port " + port + " of 127.0.0.1 is taken"));
}

}  // namespace
}  // namespace lares::testing
