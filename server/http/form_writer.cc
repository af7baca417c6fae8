#include <random>
#include <system_error>

#include "base/error.h"
#include "server/http/multipart.h"

namespace lares::http {
namespace {

// 32 random hexadecimal digits: no file contains them by accident.
std::string RandomBoundary() {
  static constexpr char kHex[] = "0123456789abcdef";
  std::random_device random;
  std::string boundary = "lares-";
  for (int i = 0; i < 32; ++i) boundary += kHex[random() % 16];
  return boundary;
}

std::string Quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) quoted += c;
  }
  return quoted + "\"";
}

std::string PartHead(const FormPart& part, const std::string& boundary) {
  std::string head = "--" + boundary + "\r\nContent-Disposition: form-data; name=";
  head += Quoted(part.name);
  if (!part.file_name.empty()) head += "; filename=" + Quoted(part.file_name);
  if (!part.content_type.empty()) head += "\r\nContent-Type: " + part.content_type;
  return head + "\r\n\r\n";
}

std::uint64_t FileSize(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) {
    throw Error(Code::kIo, "cannot read '" + file.string() + "': " + error.message());
  }
  return size;
}

}  // namespace

EncodedForm EncodeForm(const std::vector<FormPart>& parts) {
  const std::string boundary = RandomBoundary();
  EncodedForm form;
  form.content_type = "multipart/form-data; boundary=" + boundary;
  const auto add_text = [&form](std::string text) {
    form.length += text.size();
    const std::uint64_t length = text.size();
    form.pieces.push_back({std::move(text), {}, length});
  };
  for (const FormPart& part : parts) {
    add_text(PartHead(part, boundary));
    if (part.file.empty()) {
      add_text(part.text);
    } else {
      const std::uint64_t size = FileSize(part.file);
      form.pieces.push_back({"", part.file, size});
      form.length += size;
    }
    add_text("\r\n");
  }
  add_text("--" + boundary + "--\r\n");
  return form;
}

}  // namespace lares::http
