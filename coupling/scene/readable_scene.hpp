// A scene's text for the eye.
#pragma once

#include <string>

namespace clogflow {

/// The text of effective_scene with every quantity as people write it: "60 deg" for
/// "1.0471975511965976 rad". It is read back to the same scene, bit for bit. Files and names made
/// from a scene keep the text in SI units, so that they do not depend on what is pleasant to read.
/// Lines that are no key of a scene, or hold no quantity, stay as they are.
std::string readable_scene(const std::string& effective_scene);

/// One value of such a text, or as it is if the key holds no quantity. \param key  such as "geometry.half_angle"
std::string readable_value(const std::string& key, const std::string& value);

}  // namespace clogflow
