#include "benchmarks/robots.h"

#include <random>
#include <sstream>

namespace lares::bench {
namespace {

// Each number of a quantity (`lares:…_m "0.42"^^xsd:double`) times 0.5 to 1.5.
std::string Scaled(const std::string& line, std::mt19937& random) {
  const std::size_t open = line.find('"');
  const std::size_t close = line.find("\"^^xsd:double");
  if (open == std::string::npos || close == std::string::npos || open >= close) return line;
  if (line.find("lares:") == std::string::npos) return line;
  std::size_t read = 0;
  double value = 0;
  try {
    value = std::stod(line.substr(open + 1, close - open - 1), &read);
  } catch (const std::exception&) {
    return line;
  }
  if (read != close - open - 1) return line;
  value *= 0.5 + static_cast<double>(random() % 1000) / 1000;
  return line.substr(0, open + 1) + std::to_string(value) + line.substr(close);
}

// A list entry of subComponent on a line of its own: ":arm ,".
bool IsListed(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first != std::string::npos && first >= 8 && line[first] == ':' && line.ends_with(" ,");
}

bool IsMatrix(const std::string& line) {
  return line.find("lares:m") != std::string::npos && line.find("lares:max") == std::string::npos &&
         line.find("lares:min") == std::string::npos;
}

}  // namespace

std::string VariedRobot(const std::string& model, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::istringstream in(model);
  std::ostringstream out;
  const std::string name = "https://example.org/robots/robot" + std::to_string(seed);
  for (std::string line; std::getline(in, line);) {
    const std::size_t iri = line.find("https://w3id.org/lares/robots/");
    if (iri != std::string::npos) {
      const std::size_t end = line.find_first_of("#>", iri);
      line.replace(iri, end - iri, name);
    }
    if (IsListed(line) && random() % 3 == 0) continue;
    if (line.find("hasCapability") != std::string::npos) {
      std::string filler;
      if (std::getline(in, filler) && (random() % 3 != 0 || filler.ends_with("."))) {
        out << line << "\n" << filler << "\n";
      }
      continue;
    }
    out << (IsMatrix(line) ? line : Scaled(line, random)) << "\n";
  }
  return out.str();
}

}  // namespace lares::bench
