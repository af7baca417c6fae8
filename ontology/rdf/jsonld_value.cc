#include "ontology/rdf/jsonld_value.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "ontology/rdf/position.h"
#include "ontology/rdf/term_checks.h"

namespace lares::rdf::jsonld {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostValues = 4'000'000;
constexpr std::size_t kDeepest = 1000;

bool ComesBefore(const Member& a, const Member& b) { return a.key < b.key; }

// nlohmann's parser says what comes next, and not where: the places of tokens are found in the text
// beside it, which is known to be well-formed as far as the parser has come.
class TreeBuilder : public nlohmann::json_sax<Json> {
 public:
  TreeBuilder(std::string_view text, const ReadOptions& options)
      : text_(text),
        options_(options),
        deepest_(
            std::clamp<std::size_t>(static_cast<std::size_t>(options.max_depth), 1, kDeepest)) {}

  Value Take() { return std::move(root_); }

  bool null() override {
    Put(Value::Kind::kNull, 4);
    return true;
  }
  bool boolean(bool value) override {
    Put(Value::Kind::kBoolean, value ? 4 : 5).boolean = value;
    return true;
  }
  bool number_integer(number_integer_t) override { return PutNumber(); }
  bool number_unsigned(number_unsigned_t) override { return PutNumber(); }
  bool number_float(number_float_t, const string_t&) override { return PutNumber(); }
  bool string(string_t& value) override {
    Put(Value::Kind::kString, StringLength(Next())).text = std::move(value);
    return true;
  }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return Open(Value::Kind::kObject); }
  bool start_array(std::size_t) override { return Open(Value::Kind::kArray); }
  bool key(string_t& name) override {
    const std::size_t at = Next();
    end_ = at + StringLength(at);
    open_.back()->members.push_back({std::move(name), static_cast<std::uint32_t>(at), {}});
    return true;
  }
  bool end_object() override {
    std::vector<Member>& members = open_.back()->members;
    std::stable_sort(members.begin(), members.end(), ComesBefore);
    for (std::size_t i = 1; i < members.size(); ++i) {
      if (members[i].key != members[i - 1].key) continue;
      Fail(Code::kInvalid, "the key " + Quoted(members[i].key) + " is there twice in one object",
           members[i].offset);
    }
    return Close();
  }
  bool end_array() override { return Close(); }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    std::string message = error.what();
    const std::size_t column = message.find(", column ");
    const std::size_t colon = column == std::string::npos ? column : message.find(": ", column + 1);
    const std::size_t bracket = message.find("] ");
    if (colon != std::string::npos) {
      message.erase(0, colon + 2);
    } else if (bracket != std::string::npos) {
      message.erase(0, bracket + 2);
    }
    Fail(Code::kInvalid, "this is no JSON: " + message, position == 0 ? 0 : position - 1);
  }

 private:
  [[noreturn]] void Fail(Code code, const std::string& message, std::size_t offset) const {
    throw Error(code, message, PlaceAt(text_, offset, options_.source));
  }

  // Where the token begins that the parser has just read.
  std::size_t Next() const {
    return std::min(text_.find_first_not_of(" \t\r\n,:", end_), text_.size());
  }

  std::size_t StringLength(std::size_t begin) const {
    std::size_t at = begin + 1;
    while (at < text_.size() && text_[at] != '"') at += text_[at] == '\\' ? 2 : 1;
    return at + 1 - begin;
  }

  Value& Put(Value::Kind kind, std::size_t length) {
    const std::size_t at = Next();
    if (++count_ > kMostValues) {
      Fail(Code::kTooLarge, "more than " + std::to_string(kMostValues) + " JSON values", at);
    }
    end_ = at + length;
    Value* value = &root_;
    if (!open_.empty() && open_.back()->is_array()) value = &open_.back()->items.emplace_back();
    if (!open_.empty() && open_.back()->is_object()) value = &open_.back()->members.back().value;
    value->kind = kind;
    value->offset = static_cast<std::uint32_t>(at);
    return *value;
  }

  bool PutNumber() {
    const std::size_t at = Next();
    const std::size_t end = std::min(text_.find_first_not_of("0123456789+-.eE", at), text_.size());
    Put(Value::Kind::kNumber, end - at).text = text_.substr(at, end - at);
    return true;
  }

  // The containers that are open stay where they are: only the innermost one grows.
  bool Open(Value::Kind kind) {
    if (open_.size() >= deepest_) {
      Fail(Code::kTooLarge, "nested deeper than " + std::to_string(deepest_) + " levels", Next());
    }
    Value& value = Put(kind, 1);
    open_.push_back(&value);
    return true;
  }

  bool Close() {
    end_ = Next() + 1;
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const ReadOptions& options_;
  std::size_t deepest_;
  std::size_t end_ = 0;  // of the last token
  std::size_t count_ = 0;
  Value root_;
  std::vector<Value*> open_;
};

}  // namespace

const Value* Value::Find(std::string_view key) const {
  const auto found = std::lower_bound(
      members.begin(), members.end(), key,
      [](const Member& member, std::string_view wanted) { return member.key < wanted; });
  return found != members.end() && found->key == key ? &found->value : nullptr;
}

bool AreEqual(const Value& a, const Value& b) {
  if (a.kind != b.kind || a.boolean != b.boolean || a.text != b.text) return false;
  return std::equal(a.items.begin(), a.items.end(), b.items.begin(), b.items.end(), AreEqual) &&
         std::equal(a.members.begin(), a.members.end(), b.members.begin(), b.members.end(),
                    [](const Member& x, const Member& y) {
                      return x.key == y.key && AreEqual(x.value, y.value);
                    });
}

Value ParseJson(std::string_view text, const ReadOptions& options) {
  if (text.size() > UINT32_MAX) {
    throw Error(Code::kTooLarge, "JSON of more than 4 GiB is not read", {options.source, 0, 0});
  }
  TreeBuilder builder(text, options);
  Json::sax_parse(text.begin(), text.end(), &builder);
  return builder.Take();
}

}  // namespace lares::rdf::jsonld
