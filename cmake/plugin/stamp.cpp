// Part of every plugin: what `dda --plugin` reads before it loads one.
#include "framework/plugin/stamp.hpp"

extern "C" [[gnu::used, gnu::visibility("default")]] const char ddapath_plugin_stamp[] =
    DDA_PLUGIN_MARK DDA_PLUGIN_STAMP;
