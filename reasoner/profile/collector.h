// Gathers findings: what is the same is told once, with where it is.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoner/profile/document_index.h"
#include "reasoner/profile/finding.h"

namespace lares::profile {

class Collector {
 public:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  // `text` is what the document was read from, with or without Document::lines.
  Collector(const DocumentIndex& index, std::string_view text, std::string source);

  // A fault in statement `statement` (kNone: anywhere) about `term`, whose name is looked for in
  // the text. `name` is what to call it; empty for the term's own local name.
  void Add(Kind kind, const std::string& message, std::uint32_t statement, std::uint32_t term,
           const std::string& name = "");

  // "Cup"; "something unnamed" for a blank node.
  std::string NameOf(std::uint32_t term) const;
  // The first statement that mentions the term; kNone.
  std::uint32_t FirstMention(std::uint32_t term) const { return mentions_[term]; }

  Report Take();

 private:
  Place PlaceOf(std::uint32_t statement, std::uint32_t term) const;
  Place PlaceOfOffset(std::size_t offset) const;

  const DocumentIndex& index_;
  std::string_view text_;
  std::string source_;
  std::vector<std::size_t> line_starts_;
  std::vector<std::uint32_t> mentions_;  // by term
  struct Group {
    Finding finding;
    std::map<std::string, bool> seen_names;
  };
  std::map<std::pair<Kind, std::string>, Group> groups_;
};

}  // namespace lares::profile
