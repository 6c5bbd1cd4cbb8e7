#pragma once

#include <cstddef>
#include <string>

/// Names of columns of curve.csv by which others read it.
namespace dda::column {

inline constexpr const char* step = "step";
inline constexpr const char* stage = "stage";
inline constexpr const char* load = "load";
inline constexpr const char* load_factor = "load_factor";
inline constexpr const char* dissipated_energy = "dissipated_energy";
inline constexpr const char* stored_energy = "stored_energy";
inline constexpr const char* external_work = "external_work";
inline constexpr const char* current_stiffness = "current_stiffness";
inline constexpr const char* negative_eigenvalues = "negative_eigenvalues";
inline constexpr const char* negative_under_control = "negative_under_control";
inline constexpr const char* negative_second_order_work = "negative_second_order_work";
inline constexpr const char* rigid_modes = "rigid_modes";

/// Modes are counted from 1.
inline std::string mu(std::size_t mode) { return "mu_" + std::to_string(mode); }
inline std::string frequency(std::size_t mode) { return "frequency_" + std::to_string(mode); }
inline std::string mu_ratio(std::size_t mode) { return "mu_ratio_" + std::to_string(mode); }

}  // namespace dda::column
