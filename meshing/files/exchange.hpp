#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "framework/base/errors.hpp"
#include "meshing/files/gmsh_model.hpp"

namespace dda {

/// What two processes of this program tell each other, as bytes: unpacked<T>(packed(x)) is x, bit for bit. A
/// layout's model stays where it is. `unpacked` throws std::runtime_error for bytes that are no T.
template <class T>
std::string packed(const T& value);
template <class T>
T unpacked(std::string_view bytes);

extern template std::string packed(const Layout&);
extern template std::string packed(const Cells&);
extern template std::string packed(const ElementWish&);
extern template std::string packed(const std::vector<Finding>&);
extern template Layout unpacked(std::string_view);
extern template Cells unpacked(std::string_view);
extern template ElementWish unpacked(std::string_view);
extern template std::vector<Finding> unpacked(std::string_view);

}  // namespace dda
