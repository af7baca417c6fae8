#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text.h"
#include "server/access/access.h"
#include "server/cli/command.h"
#include "server/cli/print.h"
#include "server/cli/store_place.h"
#include "server/cli/when.h"

namespace lares::cli {
namespace {

constexpr const char* kCollection = "/v1/tokens";

struct TokenOptions {
  std::string role;
  std::string label;
  std::vector<std::string> environments;
  std::string expires = "365d";
  access::Limits limits;
  StorePlace place;
};

std::optional<Time> ExpiryOf(const TokenOptions& token) {
  if (token.expires == "never") return std::nullopt;
  return ParseWhen(token.expires, Now(), 1);
}

// The text alone goes to standard output, so that LARES_TOKEN=$(lares token create …) takes it.
void ShowCreated(const Json& token, const Options& options) {
  if (options.json) return PrintJson(token);
  std::string reach;
  for (const Json& pattern : token.at("environments")) {
    reach += (reach.empty() ? "" : ", ") + pattern.get<std::string>();
  }
  const std::string expires = TextOf(token, "expires");
  std::fprintf(stderr,
               "token %s of %s: %s, environments %s, expires %s\n"
               "Its text is shown now and never again:\n",
               TextOf(token, "id").c_str(), TextOf(token, "label").c_str(),
               TextOf(token, "role").c_str(), reach.empty() ? "all" : reach.c_str(),
               expires.empty() ? "never" : FormatTime(expires).c_str());
  Print(TextOf(token, "token") + "\n");
}

Json CreateOverHttp(const TokenOptions& token, const Options& options) {
  Json body{{"label", token.label},
            {"role", token.role},
            {"environments", token.environments},
            {"max_requests_per_minute", token.limits.max_requests_per_minute},
            {"max_bytes_per_day", token.limits.max_bytes_per_day},
            {"max_queries", token.limits.max_queries}};
  if (const auto expires = ExpiryOf(token)) body["expires"] = ToRfc3339(*expires);
  return Remote(options.server).SendJson("POST", kCollection, body);
}

// Into a store itself; a folder may not be open in a server.
Json CreateInStore(const TokenOptions& token) {
  if (token.place.store.empty() && !std::filesystem::is_directory(token.place.data)) {
    throw Error(Code::kNotFound, "'" + token.place.data + "' is no folder")
        .WithHint("give the folder that lares serve --data is given; for a new store, make it");
  }
  const auto store = OpenStore(token.place);
  const auto role = access::ParseRole(token.role);
  const access::CreatedToken created =
      access::CreateToken(*store,
                          {token.label, role.value_or(access::Role::kPublic), token.environments,
                           ExpiryOf(token), token.limits},
                          Now());
  Json json{{"id", created.record.id},
            {"token", created.token},
            {"label", created.record.label},
            {"role", created.record.role},
            {"environments", created.record.environments},
            {"expires", nullptr}};
  if (created.record.expires) json["expires"] = ToRfc3339(*created.record.expires);
  return json;
}

void AddCreate(CLI::App& parent, const Options& options) {
  auto* command = AddCommand(
      parent, "create", "Make a token; its text is printed once",
      "  lares token create --role admin --label me --data ~/.local/share/lares/store\n"
      "  lares token create --role robot --environment 'flat-*' --expires 90d --label kitchen-bot");
  auto token = std::make_shared<TokenOptions>();
  command
      ->add_option("--role", token->role,
                   "reader (asks), robot (and puts environments, plans), editor (and documents) or "
                   "admin (and tokens)")
      ->required()
      ->check(CLI::IsMember({"reader", "robot", "editor", "admin"}));
  command->add_option("--label", token->label, "whose it is")->required();
  command
      ->add_option("--environment", token->environments,
                   "id, or the beginning of ids and '*'; again for more; without it all")
      ->expected(1)
      ->take_all();
  command->add_option("--expires", token->expires, "90d, 12h, a time, or never")
      ->capture_default_str();
  command->add_option("--max-requests-per-minute", token->limits.max_requests_per_minute, "0: any")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--max-bytes-per-day", token->limits.max_bytes_per_day, "stored; 0: any")
      ->check(CLI::NonNegativeNumber)
      ->transform(CLI::AsSizeValue(false))
      ->capture_default_str();
  command->add_option("--max-queries", token->limits.max_queries, "at the same time; 0: any")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  AddStorePlace(*command, token->place);
  command->callback([token, &options] {
    ShowCreated(IsNamed(token->place) ? CreateInStore(*token) : CreateOverHttp(*token, options),
                options);
  });
}

void AddList(CLI::App& parent, const Options& options) {
  auto* command = AddCommand(parent, "list", "The tokens that were made",
                             "  lares token list\n  lares token list --json");
  command->callback([&options] {
    const Json list = Remote(options.server).GetList(kCollection);
    if (options.json) return PrintJson(list);
    std::vector<std::vector<std::string>> rows;
    for (const Json& token : list.at("items")) {
      std::string reach;
      for (const Json& pattern : token.at("environments")) {
        reach += (reach.empty() ? "" : " ") + pattern.get<std::string>();
      }
      const std::string expires = TextOf(token, "expires");
      rows.push_back({TextOf(token, "id"), TextOf(token, "label"), TextOf(token, "role"),
                      TextOf(token, "state"), expires.empty() ? "never" : FormatTime(expires),
                      reach.empty() ? "all" : reach});
    }
    if (rows.empty())
      return Print("there is no token: everybody of this machine may do anything\n");
    Print(FormatTable({"id", "label", "role", "state", "expires", "environments"}, rows));
  });
}

void AddRevoke(CLI::App& parent, const Options& options) {
  auto* command =
      AddCommand(parent, "revoke", "Refuse a token from now on", "  lares token revoke k3jq2m7a5x");
  auto ids = std::make_shared<std::vector<std::string>>();
  command->add_option("ID", *ids, "as lares token list shows it")->required();
  command->callback([ids, &options] {
    Remote remote(options.server);
    for (const std::string& id : *ids) {
      http::ClientRequest request;
      request.method = "DELETE";
      request.path = PathOf(kCollection, {id});
      const Json revoked = Json::parse(remote.Send(request).body);
      if (options.json) {
        PrintJson(revoked);
      } else {
        Print("token " + id + " of " + TextOf(revoked, "label") + " is revoked\n");
      }
    }
  });
}

}  // namespace

void AddToken(CLI::App& app, const Options& options) {
  auto* token = AddCommand(app, "token", "Who may ask the server, and for what",
                           "  lares token create --role reader --label dashboard\n"
                           "  lares token list");
  token->require_subcommand(1);
  AddCreate(*token, options);
  AddList(*token, options);
  AddRevoke(*token, options);
}

}  // namespace lares::cli
