#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "ontology/triples/dictionary.h"

namespace lares::rdf {
namespace {

TEST(DictionaryTest, OneTermHasOneIdAndReadsBack) {
  Dictionary dictionary;
  const Term term = Term::Literal("12", "http://www.w3.org/2001/XMLSchema#int");
  const TermId id = dictionary.Intern(term.view());
  EXPECT_EQ(dictionary.Intern(term.view()), id);
  EXPECT_EQ(dictionary.Find(term.view()), id);
  EXPECT_EQ(dictionary.Get(id), term.view());
  EXPECT_EQ(dictionary.Kind(id), TermKind::kLiteral);
  EXPECT_EQ(dictionary.size(), 1U);
}

TEST(DictionaryTest, KindDatatypeAndLanguageDistinguish) {
  Dictionary dictionary;
  const std::vector<Term> terms = {Term::Iri("x"),
                                   Term::Blank("x"),
                                   Term::Literal("x"),
                                   Term::Literal("x", "http://a"),
                                   Term::Literal("x", "http://b"),
                                   Term::Literal("x", {}, "en"),
                                   Term::Literal("x", {}, "de"),
                                   Term::Literal("")};
  for (const Term& term : terms) dictionary.Intern(term.view());
  EXPECT_EQ(dictionary.size(), terms.size());
  for (std::size_t i = 0; i < terms.size(); ++i) {
    EXPECT_EQ(dictionary.Get(TermId{static_cast<std::uint32_t>(i + 1)}), terms[i].view());
  }
}

TEST(DictionaryTest, StringIsThePlainLiteral) {
  Dictionary dictionary;
  const TermId plain = dictionary.Intern(Term::Literal("x").view());
  EXPECT_EQ(dictionary.Intern(Term::Literal("x", "http://www.w3.org/2001/XMLSchema#string").view()),
            plain);
  EXPECT_EQ(dictionary.Get(plain).datatype, "");
}

TEST(DictionaryTest, UnknownTermsAndIdsAreToldApartFromKnownOnes) {
  Dictionary dictionary;
  dictionary.InternIri("http://a");
  EXPECT_EQ(dictionary.FindIri("http://b"), std::nullopt);
  EXPECT_THROW(dictionary.Get(kAnyTerm), Error);
  EXPECT_THROW(dictionary.Get(TermId{2}), Error);
}

TEST(DictionaryTest, ViewsStayValidWhileItGrows) {
  Dictionary dictionary;
  const TermView first = dictionary.Get(dictionary.InternIri("http://first"));
  for (int i = 0; i < 50'000; ++i) dictionary.InternIri("http://example.org/" + std::to_string(i));
  EXPECT_EQ(first.value, "http://first");
  EXPECT_EQ(dictionary.Get(TermId{40'001}).value, "http://example.org/39999");
  EXPECT_EQ(dictionary.FindIri("http://example.org/49999"), TermId{50'001});
  EXPECT_LT(dictionary.memory_bytes(), 10'000'000U);
}

TEST(DictionaryTest, TextLongerThanAnyBlockIsKeptWhole) {
  Dictionary dictionary;
  const std::string text(3'000'000, 'x');
  const TermId id = dictionary.Intern(Term::Literal(text).view());
  dictionary.InternIri("http://after");
  EXPECT_EQ(dictionary.Get(id).value, text);
}

// Run under the tsan preset too: threads intern overlapping terms while others look them up.
TEST(DictionaryTest, ConcurrentUsersAgreeOnIds) {
  Dictionary dictionary;
  constexpr int kThreads = 4;
  constexpr int kTerms = 3000;
  std::vector<std::vector<TermId>> ids(kThreads, std::vector<TermId>(kTerms));
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  threads.reserve(kThreads);
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      std::mt19937 random(static_cast<unsigned>(t));
      for (int i = 0; i < kTerms; ++i) {
        const int number = static_cast<int>((i * 7919L + t * 13L) % kTerms);
        const std::string iri = "http://example.org/" + std::to_string(number);
        const TermId id = dictionary.InternIri(iri);
        ids[static_cast<std::size_t>(t)][static_cast<std::size_t>(number)] = id;
        if (dictionary.Get(id).value != iri) ++wrong;
        if (dictionary.FindIri(iri) != id) ++wrong;
        const auto other = static_cast<std::uint32_t>(1 + random() % dictionary.size());
        if (dictionary.Get(TermId{other}).value.empty()) ++wrong;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(dictionary.size(), static_cast<std::size_t>(kTerms));
  for (int t = 1; t < kThreads; ++t) EXPECT_EQ(ids[static_cast<std::size_t>(t)], ids[0]);
}

}  // namespace
}  // namespace lares::rdf
