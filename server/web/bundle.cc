#include "server/web/bundle.h"

#include <array>
#include <string>
#include <utility>

#include "base/error.h"

// The file's bytes between two symbols of the read-only data.
#define LARES_BUNDLE(symbol, file)                                                               \
  __asm__(".pushsection .rodata\n.balign 16\n" #symbol "_begin:\n.incbin \"" file "\"\n" #symbol \
          "_end:\n.byte 0\n.popsection\n");                                                      \
  extern "C" const char symbol##_begin[] __attribute__((visibility("hidden")));                  \
  extern "C" const char symbol##_end[] __attribute__((visibility("hidden")))

LARES_BUNDLE(lares_web_index_html, LARES_WEB_FOLDER "/index.html");
LARES_BUNDLE(lares_web_index_js, LARES_WEB_FOLDER "/index.js");
LARES_BUNDLE(lares_web_docs_html, LARES_WEB_FOLDER "/docs.html");
LARES_BUNDLE(lares_web_docs_js, LARES_WEB_FOLDER "/docs.js");
LARES_BUNDLE(lares_web_page_css, LARES_WEB_FOLDER "/page.css");
LARES_BUNDLE(lares_web_operations_json, LARES_API_FOLDER "/operations.json");

namespace lares::web {

std::string_view Bundled(std::string_view name) {
  const auto between = [](const char* begin, const char* end) {
    return std::string_view(begin, static_cast<std::size_t>(end - begin));
  };
  static const std::array<std::pair<std::string_view, std::string_view>, 6> kFiles{{
      {"index.html", between(lares_web_index_html_begin, lares_web_index_html_end)},
      {"index.js", between(lares_web_index_js_begin, lares_web_index_js_end)},
      {"docs.html", between(lares_web_docs_html_begin, lares_web_docs_html_end)},
      {"docs.js", between(lares_web_docs_js_begin, lares_web_docs_js_end)},
      {"page.css", between(lares_web_page_css_begin, lares_web_page_css_end)},
      {"operations.json", between(lares_web_operations_json_begin, lares_web_operations_json_end)},
  }};
  for (const auto& [known, bytes] : kFiles) {
    if (known == name) return bytes;
  }
  throw Error(Code::kInternal, "no file '" + std::string(name) + "' is bundled");
}

}  // namespace lares::web
