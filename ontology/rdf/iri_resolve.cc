#include "ontology/rdf/iri_resolve.h"

#include <optional>

namespace lares::rdf {
namespace {

// RFC 3986, appendix B. `scheme` without ':', `authority` without "//", and so on.
struct Parts {
  std::optional<std::string_view> scheme, authority;
  std::string_view path;
  std::optional<std::string_view> query, fragment;
};

Parts Split(std::string_view iri) {
  Parts parts;
  if (const std::size_t hash = iri.find('#'); hash != std::string_view::npos) {
    parts.fragment = iri.substr(hash + 1);
    iri = iri.substr(0, hash);
  }
  if (const std::size_t mark = iri.find('?'); mark != std::string_view::npos) {
    parts.query = iri.substr(mark + 1);
    iri = iri.substr(0, mark);
  }
  const std::size_t stop = iri.find_first_of(":/");
  if (stop != std::string_view::npos && stop > 0 && iri[stop] == ':') {
    parts.scheme = iri.substr(0, stop);
    iri = iri.substr(stop + 1);
  }
  if (iri.starts_with("//")) {
    const std::size_t end = iri.find('/', 2);
    parts.authority = iri.substr(2, end == std::string_view::npos ? end : end - 2);
    iri = end == std::string_view::npos ? std::string_view() : iri.substr(end);
  }
  parts.path = iri;
  return parts;
}

void DropLastSegment(std::string& path) {
  const std::size_t slash = path.rfind('/');
  path.resize(slash == std::string::npos ? 0 : slash);
}

// RFC 3986, 5.2.4.
std::string WithoutDots(std::string_view in) {
  std::string out;
  while (!in.empty()) {
    if (in.starts_with("../")) {
      in.remove_prefix(3);
    } else if (in.starts_with("./") || in.starts_with("/./")) {
      in.remove_prefix(2);
    } else if (in == "/.") {
      in = "/";
    } else if (in.starts_with("/../")) {
      in.remove_prefix(3);
      DropLastSegment(out);
    } else if (in == "/..") {
      in = "/";
      DropLastSegment(out);
    } else if (in == "." || in == "..") {
      in = {};
    } else {
      const std::size_t end = in.find('/', 1);
      out += in.substr(0, end);
      in.remove_prefix(end == std::string_view::npos ? in.size() : end);
    }
  }
  return out;
}

std::string Merge(const Parts& base, std::string_view path) {
  if (base.authority && base.path.empty()) return "/" + std::string(path);
  const std::size_t slash = base.path.rfind('/');
  if (slash == std::string_view::npos) return std::string(path);
  return std::string(base.path.substr(0, slash + 1)) + std::string(path);
}

}  // namespace

void ResolveIri(std::string_view reference, std::string_view base_iri, std::string& out) {
  const Parts relative = Split(reference);
  const Parts base = Split(base_iri);
  const bool has_authority = relative.scheme || relative.authority;
  std::string path;
  std::optional<std::string_view> query = relative.query;
  if (has_authority || relative.path.starts_with('/')) {
    path = WithoutDots(relative.path);
  } else if (relative.path.empty()) {
    path = base.path;
    if (!query) query = base.query;
  } else {
    path = WithoutDots(Merge(base, relative.path));
  }
  const auto authority = has_authority ? relative.authority : base.authority;
  out.clear();
  const auto& scheme = relative.scheme ? relative.scheme : base.scheme;
  if (scheme) out.append(*scheme).append(":");
  if (authority) out.append("//").append(*authority);
  out.append(path);
  if (query) out.append("?").append(*query);
  if (relative.fragment) out.append("#").append(*relative.fragment);
}

}  // namespace lares::rdf
