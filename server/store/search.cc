#include "server/store/search.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "base/error.h"
#include "base/text.h"
#include "server/store/conditions.h"
#include "server/store/environments.h"

namespace lares::store {
namespace {

// Of the semantic layer; "layer" and "word" are the store's own.
constexpr std::array<std::string_view, 6> kSemanticFields = {"room-number", "street", "building",
                                                             "level",       "type",   "holds"};
constexpr std::string_view kLayer = "layer";
constexpr std::string_view kWord = "word";

constexpr std::size_t kMaxWordBytes = 64;
constexpr std::size_t kMaxValueBytes = 1000;
constexpr std::size_t kMaxWords = 500;
// Beyond so many matches one condition counts as being as good as another to begin with.
constexpr int kManyMatches = 2000;
constexpr std::size_t kBatch = 256;

bool IsSemantic(std::string_view field) {
  return std::find(kSemanticFields.begin(), kSemanticFields.end(), field) != kSemanticFields.end();
}

std::string Fields() {
  std::string fields;
  for (const std::string_view field : kSemanticFields) fields += std::string(field) + ", ";
  return fields + "layer, word";
}

bool IsWordByte(unsigned char byte) { return byte >= 0x80 || std::isalnum(byte) != 0; }

// What is between spaces and punctuation, in lower case; letters beyond ASCII as they are.
void AddWords(std::string_view text, std::set<std::string>& words) {
  std::string word;
  const auto end = [&] {
    if (!word.empty() && word.size() <= kMaxWordBytes && words.size() < kMaxWords) {
      words.insert(ToLower(word));
    }
    word.clear();
  };
  for (const char byte : text) {
    if (IsWordByte(static_cast<unsigned char>(byte))) {
      word += byte;
    } else {
      end();
    }
  }
  end();
}

std::string WordsOf(const SearchKey& key) {
  const bool is_class = key.field == "type" || key.field == "holds";
  return is_class ? std::string(LocalName(key.value)) : key.value;
}

void PutKey(Database& database, const std::string& environment, std::string_view source,
            const SearchKey& key) {
  const std::string lowered = ToLower(key.value);
  database.Run("INSERT INTO environment_keys VALUES (?, ?, ?, ?) ON CONFLICT DO NOTHING",
               {key.field, lowered, environment, source});
  if (key.field == kWord) return;
  database.Run("INSERT INTO environment_values VALUES (?, ?, ?) ON CONFLICT DO NOTHING",
               {key.field, lowered, key.value});
}

void ReplaceKeys(Database& database, const std::string& environment, std::string_view source,
                 const std::vector<SearchKey>& keys) {
  database.Run("DELETE FROM environment_keys WHERE environment = ? AND source = ?",
               {environment, source});
  for (const SearchKey& key : keys) PutKey(database, environment, source, key);
}

void ReplaceSemanticKeys(Database& database, const std::string& environment,
                         const std::vector<SearchKey>& keys) {
  std::vector<SearchKey> all = keys;
  std::set<std::string> words;
  for (const SearchKey& key : keys) AddWords(WordsOf(key), words);
  for (const std::string& word : words) all.push_back({std::string(kWord), word});
  ReplaceKeys(database, environment, "semantic", all);
  database.Run("UPDATE environments SET has_keys = 1 WHERE id = ?", {environment});
}

// The ids that a condition allows, in order, from one to the next.
class Matches {
 public:
  Matches(Database& database, const SearchCondition& condition)
      : database_(&database), field_(condition.field) {
    for (const std::string& value : condition.any_of) {
      if (condition.prefix) {
        AddBeginning(ToLower(value));
      } else {
        values_.push_back(ToLower(value));
      }
    }
  }

  // At most kManyMatches.
  std::int64_t Count() {
    std::int64_t count = 0;
    for (const std::string& value : values_) {
      count += database_->AskInt(
          "SELECT count(*) FROM (SELECT 1 FROM environment_keys WHERE field = ? AND value = ? "
          "LIMIT ?) AS few",
          {field_, value, kManyMatches - count});
      if (count >= kManyMatches) break;
    }
    return count;
  }

  // The next ids beyond `after`, fewer than `limit` only at the end.
  std::vector<std::string> Next(const std::string& after, std::size_t limit) {
    std::set<std::string> ids;
    for (const std::string& value : values_) AddNext(value, after, limit, ids);
    std::vector<std::string> next(ids.begin(), ids.end());
    if (next.size() > limit) next.resize(limit);
    return next;
  }

  bool Allows(const std::string& id) {
    for (const std::string& value : values_) {
      if (database_->AskInt("SELECT 1 FROM environment_keys WHERE field = ? AND value = ? AND "
                            "environment = ? LIMIT 1",
                            {field_, value, id}) == 1) {
        return true;
      }
    }
    return false;
  }

 private:
  void AddBeginning(const std::string& beginning) {
    const std::string end = beginning + "\xf4\x8f\xbf\xbf";  // the last code point there is
    Query query = database_->Ask(
        "SELECT DISTINCT value FROM environment_keys WHERE field = ? AND value >= ? AND value < ? "
        "ORDER BY value LIMIT 200",
        {field_, beginning, end});
    while (query.Next()) values_.push_back(query.Text(0));
  }

  void AddNext(const std::string& value, const std::string& after, std::size_t limit,
               std::set<std::string>& ids) {
    Query query = database_->Ask(
        "SELECT DISTINCT environment FROM environment_keys WHERE field = ? AND value = ? AND "
        "environment > ? ORDER BY environment LIMIT ?",
        {field_, value, after, static_cast<std::int64_t>(limit)});
    while (query.Next()) {
      ids.insert(query.Text(0));
      // What stands beyond `limit` ids already found is for a later call.
      if (ids.size() > limit) ids.erase(std::prev(ids.end()));
    }
  }

  Database* database_;
  std::string field_;
  std::vector<std::string> values_;
};

bool InTime(const EnvironmentInfo& environment, const EnvironmentSearch& search) {
  return (!search.changed_from || environment.changed >= *search.changed_from) &&
         (!search.changed_until || environment.changed < *search.changed_until);
}

std::int64_t Millis(const std::optional<Time>& time, std::int64_t otherwise) {
  return time ? time->time_since_epoch().count() : otherwise;
}

// By time alone, when few changed then: all of them, put in order.
std::optional<std::vector<std::string>> FewChanged(Database& database,
                                                   const EnvironmentSearch& search) {
  if (!search.changed_from && !search.changed_until) return std::nullopt;
  Query query =
      database.Ask("SELECT id FROM environments WHERE changed_at >= ? AND changed_at < ? LIMIT ?",
                   {Millis(search.changed_from, INT64_MIN), Millis(search.changed_until, INT64_MAX),
                    kManyMatches});
  std::vector<std::string> ids;
  while (query.Next()) ids.push_back(query.Text(0));
  if (ids.size() == kManyMatches) return std::nullopt;
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<std::string> NextIds(Database& database, const std::string& after) {
  Query query = database.Ask("SELECT id FROM environments WHERE id > ? ORDER BY id LIMIT ?",
                             {after, static_cast<std::int64_t>(kBatch)});
  std::vector<std::string> ids;
  while (query.Next()) ids.push_back(query.Text(0));
  return ids;
}

// Adds those of `ids` that every condition and the time allow; true when there are enough.
bool AddAllowed(Database& database, const std::vector<std::string>& ids,
                std::vector<Matches>& others, const EnvironmentSearch& search,
                std::vector<EnvironmentInfo>& found) {
  for (const std::string& id : ids) {
    if (id <= search.after) continue;
    const bool allowed =
        std::all_of(others.begin(), others.end(), [&](Matches& other) { return other.Allows(id); });
    if (!allowed) continue;
    const std::optional<EnvironmentInfo> environment = FindEnvironment(database, id);
    if (environment && InTime(*environment, search)) found.push_back(*environment);
    if (found.size() == search.limit) return true;
  }
  return false;
}

}  // namespace

void UpdateKeys(Database& database, const EnvironmentVersion& head,
                const std::optional<std::vector<SearchKey>>& keys) {
  std::set<std::string> words;
  for (const std::string& text : {head.environment, head.label, head.note, head.author}) {
    AddWords(text, words);
  }
  AddWords(LocalName(head.type_iri), words);
  std::vector<SearchKey> own;
  if (!head.type_iri.empty()) own.push_back({"type", head.type_iri});
  for (const LayerInfo& layer : head.layers) own.push_back({std::string(kLayer), layer.name});
  for (const std::string& word : words) own.push_back({std::string(kWord), word});
  ReplaceKeys(database, head.environment, "version", own);
  if (keys) ReplaceSemanticKeys(database, head.environment, *keys);
}

void CheckKeys(const std::vector<SearchKey>& keys) {
  for (const SearchKey& key : keys) {
    if (!IsSemantic(key.field)) {
      throw Error(Code::kInternal, "'" + key.field + "' is no field of environments");
    }
    CheckText(key.value, "a " + key.field);
    if (key.value.size() > kMaxValueBytes) {
      throw Error(Code::kTooLarge, "the " + key.field + " '" + Shortened(key.value, 60) +
                                       "' is longer than 1000 bytes");
    }
  }
}

void CheckSearch(const EnvironmentSearch& search) {
  for (const SearchCondition& condition : search.all_of) {
    if (!IsSemantic(condition.field) && condition.field != kLayer && condition.field != kWord) {
      throw Error(Code::kInvalid, "environments have no field '" + Shortened(condition.field, 60) +
                                      "'; they have " + Fields());
    }
    for (const std::string& value : condition.any_of) CheckText(value, "a " + condition.field);
  }
}

std::vector<EnvironmentInfo> SearchEnvironments(Database& database,
                                                const EnvironmentSearch& search) {
  std::vector<EnvironmentInfo> found;
  if (search.limit == 0) return found;
  // The rarest condition is walked along, the others are asked of each id.
  std::vector<Matches> matches;
  for (const SearchCondition& condition : search.all_of) matches.emplace_back(database, condition);
  std::optional<Matches> first;
  if (!matches.empty()) {
    std::vector<std::int64_t> counts;
    for (Matches& one : matches) counts.push_back(one.Count());
    const auto rarest = std::min_element(counts.begin(), counts.end()) - counts.begin();
    first.emplace(std::move(matches[static_cast<std::size_t>(rarest)]));
    matches.erase(matches.begin() + rarest);
  } else if (const auto few = FewChanged(database, search)) {
    AddAllowed(database, *few, matches, search, found);
    return found;
  }
  const std::size_t batch = std::min(search.limit, kBatch);
  for (std::string after = search.after;;) {
    const std::vector<std::string> ids =
        first ? first->Next(after, batch) : NextIds(database, after);
    if (ids.empty() || AddAllowed(database, ids, matches, search, found)) return found;
    after = ids.back();
  }
}

std::vector<std::string> SearchValues(Database& database, const std::string& field) {
  Query query =
      database.Ask("SELECT text FROM environment_values WHERE field = ? ORDER BY value", {field});
  std::vector<std::string> values;
  while (query.Next()) values.push_back(query.Text(0));
  return values;
}

std::vector<std::string> EnvironmentsWithoutKeys(Database& database) {
  Query query = database.Ask(
      "SELECT e.id FROM environments e JOIN environment_versions v ON v.environment = e.key AND "
      "v.number = e.latest JOIN layers l ON l.version = v.key AND l.name = 'semantic' "
      "WHERE e.has_keys = 0 ORDER BY e.id");
  std::vector<std::string> ids;
  while (query.Next()) ids.push_back(query.Text(0));
  return ids;
}

void PutKeys(Database& database, const std::string& id, int number,
             const std::vector<SearchKey>& keys) {
  const EnvironmentVersion head = GetVersion(database, id, 0);
  if (head.number != number) return;
  UpdateKeys(database, head, keys);
}

}  // namespace lares::store
