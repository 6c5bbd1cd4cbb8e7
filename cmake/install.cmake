# What `cmake --install` puts below its prefix:
#
#   bin/dda
#   lib/ddapath               the modules, which the program finds by its own place (framework/base/loaded.hpp); Python's _core
#   lib/cmake/ddapath         find_package(ddapath), for plugins
#   include/ddapath           headers that plugins may include
#   share/ddapath             python, studies (decks to run), plugin (an example), notebooks, deck.schema.json (for editors)
#   share/doc/ddapath         README, CHANGELOG, LICENSE ...
#   share/man, completions    written by the program
include(CMakePackageConfigHelpers)

install(TARGETS dda EXPORT ddapathTargets RUNTIME DESTINATION bin)
install(TARGETS ${DDA_MODULES} LIBRARY DESTINATION lib/ddapath)
install(DIRECTORY python/ddapath DESTINATION share/ddapath/python FILES_MATCHING PATTERN *.py)
install(DIRECTORY studies/ DESTINATION share/ddapath/studies
  REGEX "/(dda|__pycache__)$" EXCLUDE PATTERN CMakeLists.txt EXCLUDE)
install(DIRECTORY examples/plugin examples/notebooks DESTINATION share/ddapath)
install(FILES ${CMAKE_BINARY_DIR}/share/ddapath/deck.schema.json DESTINATION share/ddapath)
install(FILES README.md CHANGELOG.md CONTRIBUTING.md CITATION.cff LICENSE DESTINATION share/doc/ddapath)

install(DIRECTORY ${CMAKE_BINARY_DIR}/share/man ${CMAKE_BINARY_DIR}/share/bash-completion ${CMAKE_BINARY_DIR}/share/zsh
  ${CMAKE_BINARY_DIR}/share/fish DESTINATION share)

# Plugins.
foreach(header IN LISTS DDA_HEADERS)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${header} DESTINATION include/ddapath/${folder})
endforeach()
install(DIRECTORY ${DDA_INTERFACE_FOLDER}/framework DESTINATION include/ddapath FILES_MATCHING PATTERN *.hpp)
install(FILES cmake/plugin/stamp.cpp DESTINATION lib/cmake/ddapath)
add_library(ddapath_plugin INTERFACE)
set_target_properties(ddapath_plugin PROPERTIES EXPORT_NAME ddapath)
target_include_directories(ddapath_plugin INTERFACE $<INSTALL_INTERFACE:include/ddapath>)
target_compile_features(ddapath_plugin INTERFACE cxx_std_20)
target_sources(ddapath_plugin INTERFACE $<INSTALL_INTERFACE:$<INSTALL_PREFIX>/lib/cmake/ddapath/stamp.cpp>)
target_link_libraries(ddapath_plugin INTERFACE Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json)
install(TARGETS ddapath_plugin EXPORT ddapathTargets)
install(EXPORT ddapathTargets NAMESPACE ddapath:: DESTINATION lib/cmake/ddapath)
configure_package_config_file(cmake/plugin/ddapathConfig.cmake.in ${CMAKE_BINARY_DIR}/cmake/ddapathConfig.cmake
  INSTALL_DESTINATION lib/cmake/ddapath NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/cmake/ddapathConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/cmake/ddapathConfig.cmake ${CMAKE_BINARY_DIR}/cmake/ddapathConfigVersion.cmake
  DESTINATION lib/cmake/ddapath)
