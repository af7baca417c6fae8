#include "ontology/rdf/jsonld_expand.h"

#include <algorithm>
#include <iterator>

#include "ontology/rdf/term_checks.h"

namespace lares::rdf::jsonld {
namespace {

constexpr ContextReader::Against kAsName{false, true};
constexpr ContextReader::Against kAsType{true, true};

void Move(std::vector<Object> from, std::vector<Object>& to) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

bool IsGraphObject(const Object& object) {
  return object.graph && object.properties.empty() && object.reverse.empty() && !object.has_types &&
         !object.included;
}

Object GraphOf(std::vector<Object> objects, std::uint32_t offset) {
  Object graph;
  graph.offset = offset;
  graph.graph = std::move(objects);
  return graph;
}

}  // namespace

std::vector<Object> Expander::Expand(const Value& root) {
  std::vector<Object> objects = ExpandElement(contexts_.Initial(), nullptr, root, false).objects;
  if (objects.size() == 1 && IsGraphObject(objects[0]) && !objects[0].id && !objects[0].index) {
    return std::move(*objects[0].graph);
  }
  return objects;
}

Expander::Result Expander::ExpandElement(const ContextPtr& active, const std::string* property,
                                         const Value& element, bool from_map) {
  if (element.is_null()) return {};
  if (element.is_array()) return ExpandArray(active, property, element, from_map);
  if (element.is_object()) return ExpandObject(active, property, element, from_map);
  if (property == nullptr || *property == "@graph") {
    warn_("a value that belongs to nothing is left out", element.offset);
    return {};
  }
  ContextPtr context = active;
  const TermDefinition* term = active->Find(*property);
  if (term != nullptr && term->context != nullptr) {
    context = contexts_.ProcessScoped(active, *term->context, {true, true});
  }
  Result result;
  result.objects.push_back(ExpandValue(*context, *property, element));
  return result;
}

Expander::Result Expander::ExpandArray(const ContextPtr& active, const std::string* property,
                                       const Value& element, bool from_map) {
  const TermDefinition* term = property == nullptr ? nullptr : active->Find(*property);
  const bool is_list = term != nullptr && (term->containers & kList) != 0;
  Result result;
  result.is_array = true;
  for (const Value& item : element.items) {
    Result expanded = ExpandElement(active, property, item, from_map);
    if (is_list && expanded.is_array) {
      Object list;
      list.offset = item.offset;
      list.list = std::move(expanded.objects);
      result.objects.push_back(std::move(list));
    } else {
      Move(std::move(expanded.objects), result.objects);
    }
  }
  return result;
}

// Whether the context reverts to that before a type's: not for values and references.
bool Expander::MustRevert(const Context& active, const Value& element) {
  for (const Member& member : element.members) {
    const auto name = Iri(active, member.key, kAsName);
    if (name == "@value") return false;
    if (name == "@id" && element.members.size() == 1) return false;
  }
  return true;
}

Expander::Result Expander::ExpandObject(ContextPtr active, const std::string* property,
                                        const Value& element, bool from_map) {
  const TermDefinition* term = property == nullptr ? nullptr : active->Find(*property);
  const Value* scoped = term == nullptr ? nullptr : term->context;
  if (active->previous && !from_map && MustRevert(*active, element)) active = active->previous;
  if (scoped != nullptr) active = contexts_.ProcessScoped(active, *scoped, {true, true});
  if (const Value* local = element.Find("@context")) {
    active = contexts_.Process(active, *local, {});
  }
  Object object;
  object.offset = element.offset;
  Work work{object, property, active, active, false, false, false, {}};
  work.active = WithTypes(active, element, work.is_json);
  ExpandMembers(work, element);
  return Finish(work, property);
}

ContextPtr Expander::WithTypes(const ContextPtr& active, const Value& element, bool& is_json) {
  ContextPtr context = active;
  const Value* first = nullptr;
  for (const Member& member : element.members) {
    if (Iri(*active, member.key, kAsName) != "@type") continue;
    if (first == nullptr) first = &member.value;
    std::vector<std::string_view> names;
    ForEachItem(member.value, [&](const Value& item) {
      if (item.is_string()) names.push_back(item.text);
    });
    std::sort(names.begin(), names.end());
    for (const std::string_view name : names) {
      const TermDefinition* term = active->Find(name);
      if (term == nullptr || term->context == nullptr) continue;
      context = contexts_.ProcessScoped(context, *term->context, {false, false});
    }
  }
  if (first != nullptr) {
    const Value& last = first->is_array() && !first->items.empty() ? first->items.back() : *first;
    is_json = last.is_string() && Iri(*context, last.text, kAsName) == "@json";
  }
  return context;
}

void Expander::ExpandMembers(Work& work, const Value& element) {
  std::vector<const Member*> nested;
  for (const Member& member : element.members) {
    if (member.key == "@context") continue;
    const auto name = Iri(*work.active, member.key, kAsName);
    const bool has_meaning = name && (name->find(':') != std::string::npos || IsKeyword(*name));
    if (!has_meaning) {
      warn_("the context gives " + Quoted(member.key) + " no meaning: it is left out",
            member.offset);
    } else if (*name == "@nest") {
      nested.push_back(&member);
    } else if (IsKeyword(*name)) {
      ExpandKeyword(work, *name, member.value);
    } else {
      ExpandProperty(work, member.key, *name, member.value);
    }
  }
  for (const Member* member : nested) ExpandNested(work, member->key, member->value);
}

void Expander::ExpandNested(Work& work, const std::string& key, const Value& value) {
  const ContextPtr outer = work.active;
  const TermDefinition* term = outer->Find(key);
  ContextPtr inner = outer;
  if (term != nullptr && term->context != nullptr) {
    inner = contexts_.ProcessScoped(outer, *term->context, {true, true});
  }
  ForEachItem(value, [&](const Value& item) {
    if (!item.is_object()) fail_("@nest holds objects (invalid @nest value)", item.offset);
    for (const Member& member : item.members) {
      if (Iri(*inner, member.key, kAsName) == "@value") {
        fail_("@nest holds no @value (invalid @nest value)", member.offset);
      }
    }
    work.active = inner;
    ExpandMembers(work, item);
  });
  work.active = outer;
}

void Expander::ExpandKeyword(Work& work, const std::string& keyword, const Value& value) {
  Object& result = work.result;
  if (work.active_property != nullptr && *work.active_property == "@reverse") {
    fail_("@reverse holds properties and no keywords (invalid reverse property map)", value.offset);
  }
  if (keyword != "@included" && keyword != "@type") {
    auto& seen = work.seen;
    if (std::find(seen.begin(), seen.end(), keyword) != seen.end()) {
      fail_(keyword + " is there twice, by different names (colliding keywords)", value.offset);
    }
    seen.push_back(keyword);
  }
  if (keyword == "@id") {
    if (!value.is_string()) fail_("@id is a text (invalid @id value)", value.offset);
    result.id = Id(*work.active, value.text);
    work.has_id = true;
  } else if (keyword == "@type") {
    ExpandTypes(work, value);
  } else if (keyword == "@graph") {
    static const std::string kGraphKey = "@graph";
    result.graph = ExpandElement(work.active, &kGraphKey, value, false).objects;
  } else if (keyword == "@included") {
    ExpandIncluded(work, value);
  } else if (keyword == "@value") {
    if (!work.is_json && !value.is_scalar() && !value.is_null()) {
      fail_("@value is a text, number, true, false or null (invalid value object value)",
            value.offset);
    }
    result.value = &value;
    work.has_value = true;
  } else if (keyword == "@language") {
    if (!value.is_string()) {
      fail_("@language is a text (invalid language-tagged string)", value.offset);
    }
    result.language = value.text;
  } else if (keyword == "@direction") {
    if (value.text != "ltr" && value.text != "rtl") {
      fail_("@direction is ltr or rtl (invalid base direction)", value.offset);
    }
    result.has_direction = true;
  } else if (keyword == "@index") {
    if (!value.is_string()) fail_("@index is a text (invalid @index value)", value.offset);
    result.index = value.text;
  } else if (keyword == "@list") {
    if (work.active_property == nullptr || *work.active_property == "@graph") return;
    result.list = ExpandElement(work.active, work.active_property, value, false).objects;
  } else if (keyword == "@set") {
    result.set = ExpandElement(work.active, work.active_property, value, false).objects;
  } else if (keyword == "@reverse") {
    ExpandReverse(work, value);
  }
}

void Expander::ExpandTypes(Work& work, const Value& value) {
  std::vector<std::string> types;
  ForEachItem(value, [&](const Value& item) {
    if (!item.is_string()) {
      fail_("@type is a text or several (invalid type value)", item.offset);
    }
    types.push_back(Iri(*work.type_scoped, item.text, kAsType).value_or(""));
  });
  Object& result = work.result;
  result.types.insert(result.types.end(), types.begin(), types.end());
  result.has_types = true;
}

void Expander::ExpandIncluded(Work& work, const Value& value) {
  std::vector<Object> included = ExpandElement(work.active, nullptr, value, false).objects;
  ForEachItem(value, [&](const Value& item) {
    if (item.is_object()) return;
    fail_("@included holds nodes (invalid @included value)", item.offset);
  });
  for (const Object& object : included) {
    if (!object.is_node()) fail_("@included holds nodes (invalid @included value)", object.offset);
  }
  if (!work.result.included) work.result.included.emplace();
  Move(std::move(included), *work.result.included);
}

void Expander::AddReverse(Object& result, const std::string& property,
                          std::vector<Object> objects) {
  for (const Object& object : objects) {
    if (object.value == nullptr && !object.list) continue;
    fail_("a reverse property leads to nodes only (invalid reverse property value)", object.offset);
  }
  Move(std::move(objects), result.reverse[property]);
}

void Expander::ExpandReverse(Work& work, const Value& value) {
  if (!value.is_object()) fail_("@reverse is an object (invalid @reverse value)", value.offset);
  static const std::string kReverseKey = "@reverse";
  Result expanded = ExpandElement(work.active, &kReverseKey, value, false);
  for (Object& object : expanded.objects) {
    // What is reverse in there is forward again.
    for (auto& [property, objects] : object.reverse) {
      Move(std::move(objects), work.result.properties[property]);
    }
    for (auto& [property, objects] : object.properties) {
      AddReverse(work.result, property, std::move(objects));
    }
  }
}

void Expander::ExpandProperty(Work& work, const std::string& key, const std::string& property,
                              const Value& value) {
  static const TermDefinition kNone;
  const TermDefinition* found = work.active->Find(key);
  const TermDefinition& term = found == nullptr ? kNone : *found;
  constexpr std::uint8_t kMaps = kIndex | kId | kType;
  Result expanded;
  if (term.type == "@json") {
    Object json;
    json.offset = value.offset;
    json.value = &value;
    json.types = {"@json"};
    json.has_types = true;
    expanded.objects.push_back(std::move(json));
  } else if ((term.containers & kLanguage) != 0 && value.is_object()) {
    expanded = {true, ExpandLanguageMap(work, value)};
    for (Object& object : expanded.objects) object.has_direction = false;
  } else if ((term.containers & kMaps) != 0 && value.is_object()) {
    expanded = {true, ExpandIndexMap(work, key, term, value)};
  } else {
    expanded = ExpandElement(work.active, &key, value, false);
  }
  if (!expanded.is_array && expanded.objects.empty()) return;
  if ((term.containers & kList) != 0 && (expanded.is_array || !expanded.objects[0].list)) {
    Object list;
    list.offset = value.offset;
    list.list = std::move(expanded.objects);
    expanded.objects.clear();
    expanded.objects.push_back(std::move(list));
  }
  if ((term.containers & kGraph) != 0 && (term.containers & (kId | kIndex)) == 0) {
    for (Object& object : expanded.objects) {
      const std::uint32_t offset = object.offset;
      std::vector<Object> inside;
      inside.push_back(std::move(object));
      object = GraphOf(std::move(inside), offset);
    }
  }
  if (term.is_reverse) {
    AddReverse(work.result, property, std::move(expanded.objects));
  } else {
    Move(std::move(expanded.objects), work.result.properties[property]);
  }
}

std::vector<Object> Expander::ExpandLanguageMap(const Work& work, const Value& map) {
  std::vector<Object> objects;
  for (const Member& member : map.members) {
    ForEachItem(member.value, [&](const Value& item) {
      if (item.is_null()) return;
      if (!item.is_string()) {
        fail_("a language map holds texts (invalid language map value)", item.offset);
      }
      Object text;
      text.offset = item.offset;
      text.value = &item;
      if (Iri(*work.active, member.key, kAsName) != "@none") text.language = member.key;
      objects.push_back(std::move(text));
    });
  }
  return objects;
}

std::vector<Object> Expander::ExpandIndexMap(const Work& work, const std::string& key,
                                             const TermDefinition& term, const Value& map) {
  std::vector<Object> objects;
  for (const Member& member : map.members) {
    ContextPtr context = work.active;
    if ((term.containers & (kId | kType)) != 0 && context->previous) context = context->previous;
    if ((term.containers & kType) != 0) {
      const TermDefinition* type = context->Find(member.key);
      if (type != nullptr && type->context != nullptr) {
        context = contexts_.ProcessScoped(context, *type->context, {false, true});
      }
    }
    std::vector<Object> expanded;
    ForEachItem(member.value, [&](const Value& item) {
      Move(ExpandElement(context, &key, item, true).objects, expanded);
    });
    for (Object& object : expanded) {
      if ((term.containers & kGraph) != 0 && !IsGraphObject(object)) {
        const std::uint32_t offset = object.offset;
        std::vector<Object> inside;
        inside.push_back(std::move(object));
        object = GraphOf(std::move(inside), offset);
      }
      PlaceInIndex(work, term, member, object);
    }
    Move(std::move(expanded), objects);
  }
  return objects;
}

void Expander::PlaceInIndex(const Work& work, const TermDefinition& term, const Member& entry,
                            Object& object) {
  const std::string name = Iri(*work.active, entry.key, kAsName).value_or("");
  if (name == "@none") return;
  if ((term.containers & kIndex) != 0) {
    if (term.index.empty() || term.index == "@index") {
      if (!object.index) object.index = entry.key;
      return;
    }
    if (!object.is_node()) {
      fail_("a value has no room for the property of its index (invalid value object)",
            object.offset);
    }
    Value& text = made_.emplace_back();
    text.kind = Value::Kind::kString;
    text.offset = entry.offset;
    text.text = entry.key;
    const std::string property = Iri(*work.active, term.index, kAsName).value_or("");
    auto& values = object.properties[property];
    values.insert(values.begin(), ExpandValue(*work.active, term.index, text));
  } else if ((term.containers & kId) != 0) {
    if (!object.id) object.id = Id(*work.active, entry.key);
  } else if ((term.containers & kType) != 0) {
    object.types.insert(object.types.begin(), name);
    object.has_types = true;
  }
}

Object Expander::ExpandValue(const Context& active, const std::string& property,
                             const Value& value) {
  const TermDefinition* term = active.Find(property);
  const std::string type = term == nullptr ? "" : term->type;
  Object object;
  object.offset = value.offset;
  if (value.is_string() && (type == "@id" || type == "@vocab")) {
    object.id = Iri(active, value.text, {true, type == "@vocab"}).value_or("");
    return object;
  }
  object.value = &value;
  if (!type.empty() && type != "@id" && type != "@vocab" && type != "@none") {
    object.types = {type};
    object.has_types = true;
  } else if (value.is_string()) {
    const std::string& language =
        term != nullptr && term->has_language ? term->language : active.language;
    if (!language.empty()) object.language = language;
  }
  return object;
}

void Expander::CheckValueObject(const Object& object, bool& is_null) {
  const bool has_other = object.id || object.graph || object.included || object.list ||
                         object.set || !object.properties.empty() || !object.reverse.empty();
  const bool has_text_marks = object.language || object.has_direction;
  if (has_other || (object.has_types && has_text_marks)) {
    fail_(
        "beside @value may stand @type, or @language and @direction, and @index (invalid value "
        "object)",
        object.offset);
  }
  const bool is_json = object.types.size() == 1 && object.types[0] == "@json";
  if (is_json) return;
  if (object.value->is_null()) {
    is_null = true;
  } else if (!object.value->is_string() && object.language) {
    fail_("only a text has a language (invalid language-tagged value)", object.offset);
  } else if (object.has_types && (object.types.size() != 1 || !LooksLikeIri(object.types[0]))) {
    fail_("the type of a value is an IRI (invalid typed value)", object.offset);
  }
}

Expander::Result Expander::Finish(Work& work, const std::string* property) {
  Object& object = work.result;
  const bool is_top = property == nullptr || *property == "@graph";
  Result result;
  if (work.has_value) {
    bool is_null = false;
    CheckValueObject(object, is_null);
    if (is_null || is_top) return result;
  } else if (object.set || object.list) {
    const bool has_other = object.id || object.has_types || object.graph || object.included ||
                           object.language || object.has_direction || (object.set && object.list) ||
                           !object.properties.empty() || !object.reverse.empty();
    if (has_other) {
      fail_("beside @set or @list may stand @index only (invalid set or list object)",
            object.offset);
    }
    if (object.set) return {true, std::move(*object.set)};
    if (is_top) return result;
  } else {
    const bool is_bare = !object.has_types && !object.graph && !object.included && !object.index &&
                         object.properties.empty() && object.reverse.empty();
    if (is_bare && !object.id && (object.language || object.has_direction)) return result;
    if (is_bare && is_top && (object.id || work.seen.empty())) return result;
  }
  result.objects.push_back(std::move(object));
  return result;
}

}  // namespace lares::rdf::jsonld
