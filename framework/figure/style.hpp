#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>

namespace dda::svg {

// What all figures share, those of files and those of the report's page: each number stands here alone.

/// Okabe & Ito, Color Universal Design (2008), without its yellow, which is too light for a line on white.
inline constexpr std::array palette = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                       "#E69F00", "#56B4E9", "#000000"};
inline constexpr int blue = 0, vermilion = 1, black = palette.size() - 1;  ///< places in the palette

/// The palette mixed with white: for surfaces under lines and words.
inline constexpr std::array tints = {"#dbe9f4", "#f8e2d3", "#d5ece3", "#f5e6ee",
                                     "#faeed3", "#e3f2fb", "#e0e0e0"};

inline constexpr const char* paper = "#ffffff";
inline constexpr const char* ink = "#222222";
inline constexpr const char* faint = "#e3e3e3";
inline constexpr const char* grey = "#808080";
inline constexpr const char* block_fill = "#eeeeee";  ///< of blocks without a value
inline constexpr const char* block_edge = "#a0a0a0";
inline constexpr const char* mark_outline = "#e00000";  ///< of blocks that have been torn out

/// Jumps of cracks that a picture does not show, as part of the structure's size in it; those have a hairline.
inline constexpr double hairline = 2e-3;

/// Lengths on and off [px].
inline constexpr std::array dashes = {5, 9}, dots = {1, 4};

/// Sizes of fonts [px].
inline constexpr double small_text = 10, normal_text = 11.5, large_text = 14;

inline constexpr int colour_steps = 64;  ///< of a colour bar

inline constexpr double minor_tick = 4;  ///< length of minor ticks [px]

/// Parts of a range that axes add at both ends.
inline constexpr double axis_margin = 0.05;
/// Ranges whose length is no more than this part of their numbers have none: it is rounding.
inline constexpr double least_length = 1e-12;
/// Half of a range without length, as part of its number.
inline constexpr double half_of_no_length = 0.1;

/// Round numbers are these times a power of ten.
inline constexpr std::array round_digits = {1, 2, 5};
/// What a quotient or a logarithm may be off by, and a tick by as part of a step.
inline constexpr double rounding = 1e-9, tick_slack = 1e-6;
/// Labels have a common power of ten, a multiple of three, where the largest is at least, or at most, ten to these.
inline constexpr int large_exponent = 5, small_exponent = -4;
/// A number is taken out of labels that would be more steps than this.
inline constexpr double most_steps = 1e6;

/// All of that for the page, with the colours of each step of the colour maps.
nlohmann::ordered_json page_style();

}  // namespace dda::svg
