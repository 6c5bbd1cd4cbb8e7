#pragma once

#include <Eigen/Core>

#include "framework/plugin/interface.hpp"

// What a plugin must have in common with the program that loads it: headers, layout of classes, of texts and of aligned
// vectors. Two that differ in it would crash or compute nonsense.

#define DDA_TEXT_OF(value) DDA_TEXT(value)
#define DDA_TEXT(value) #value

/// Stands before the stamp in the file of a plugin, where it is found before anything of the plugin runs.
#define DDA_PLUGIN_MARK "ddapath plugin for: "

/// "0.1.0, headers 5f0c…, C++ ABI 1017, texts 1, vectors aligned to 16": version of the project, a hash of all headers
/// that a plugin may include, and what the compiler was told.
#define DDA_PLUGIN_STAMP                                                            \
  DDA_INTERFACE ", C++ ABI " DDA_TEXT_OF(__GXX_ABI_VERSION) ", texts " DDA_TEXT_OF( \
      _GLIBCXX_USE_CXX11_ABI) ", vectors aligned to " DDA_TEXT_OF(EIGEN_MAX_ALIGN_BYTES)
