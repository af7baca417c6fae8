// Proofs of what follows in LUBM(1).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <random>
#include <vector>

#include "reasoner/owl/prover.h"
#include "tests/lares_data.h"
#include "tests/ontology/test_graph.h"
#include "tests/reasoner/lubm.h"
#include "tests/reasoner/proof_checker.h"

namespace lares::owl {
namespace {

using lares::testing::CheckProof;
using lares::testing::ToText;

// Of this thread, so that neighbours on the machine do not count.
double CpuMilliseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

// How long it takes is printed, not judged.
TEST(ProverLubmTest, WhatFollowsHasProofsThatTheCheckerAccepts) {
  LARES_REQUIRE_DATA(lubm, "conformance/lubm");
  const rdf::View view = lares::testing::ReadLubm(lubm, std::make_shared<rdf::Dictionary>());
  std::vector<rdf::Triple> inferred = view.Match({});
  std::erase_if(inferred, [&](const rdf::Triple& triple) { return view.IsAsserted(triple); });
  std::mt19937 random(1);
  std::shuffle(inferred.begin(), inferred.end(), random);
  const char* wanted = std::getenv("LARES_PROOFS");
  inferred.resize(std::min<std::size_t>(
      inferred.size(), wanted == nullptr ? 2000 : static_cast<std::size_t>(std::atoi(wanted))));
  std::vector<std::pair<double, rdf::Triple>> times;
  unsigned longest = 0;
  for (const rdf::Triple& triple : inferred) {
    const double start = CpuMilliseconds();
    const auto proof = Prover(view).Why(triple);
    times.emplace_back(CpuMilliseconds() - start, triple);
    ASSERT_TRUE(proof);
    ASSERT_EQ(CheckProof(*proof, view), "") << ToText(triple, view.dictionary());
    longest = std::max(longest, proof->cost);
  }
  std::sort(times.begin(), times.end(), [](auto& a, auto& b) { return a.first < b.first; });
  const auto at = [&](double part) {
    return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))].first;
  };
  std::cout << times.size() << " proofs, time of the processor: median " << at(0.5) << " ms, 99 % " << at(0.99)
            << " ms, most " << at(1) << " ms (" << ToText(times.back().second, view.dictionary())
            << "), dearest " << longest << " steps\n";
}

}  // namespace
}  // namespace lares::owl
