#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "ontology/rdf/reader.h"
#include "robots/urdf/doctor.h"
#include "robots/urdf/import.h"
#include "robots/urdf/srdl.h"
#include "robots/urdf/tree_picture.h"

// Any bytes: a robot whose SRDL is Turtle, or an Error, nothing else.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lares;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  urdf::Examine(bytes, "fuzz");
  try {
    const urdf::Imported robot = urdf::Import(bytes, "fuzz");
    urdf::SrdlOptions options;
    options.id = "fuzz";
    const std::string srdl = urdf::ToSrdl(robot.model, robot.kinematics, robot.body, options);
    urdf::ToSvg(robot.model, robot.body);
    rdf::ReadOptions read;
    read.base_iri = "urn:x";
    try {
      rdf::ReadRdf(srdl, rdf::Format::kTurtle, read);
    } catch (const Error&) {
      __builtin_trap();  // what we write must be readable
    }
  } catch (const Error&) {
  }
  return 0;
}
