# `cpack -G DEB` in the build folder: a package for the Debian that it was built on.
set(DDA_MAINTAINER "The ddapath authors <ddapath@users.noreply.github.com>" CACHE STRING "Who answers for the Debian package")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ddapath)
set(CPACK_PACKAGE_VENDOR "The ddapath authors")
set(CPACK_PACKAGE_CONTACT "${DDA_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "discontinuous deformation analysis of fracture")
set(CPACK_PACKAGE_DESCRIPTION
"Follows the equilibrium of concrete and masonry structures while they
crack, from the first load through limit points and snap-back, by
numerical continuation (Trilinos NOX and LOCA), and then the motion of
the fragments.
.
The program is dda; decks to begin with are in
/usr/share/ddapath/studies. Laws, loads and controls of one's own are
plugins, for which headers and a CMake package are included.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package/debian_files.cmake)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What dpkg-shlibdeps cannot see: `dda verify` and `dda animate` become Python.
set(CPACK_DEBIAN_PACKAGE_DEPENDS
  "python3, python3-h5py, python3-matplotlib, python3-numpy, python3-pandas, python3-pil, python3-yaml")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, python3-scipy, python3-skimage, python3-svgelements, python3-ezdxf, python3-gmsh, python3-meshio, g++, cmake, libeigen3-dev, libfmt-dev, nlohmann-json3-dev")
set(CPACK_DDA_CHANGELOG "${PROJECT_SOURCE_DIR}/cmake/package/changelog.in")
set(CPACK_DDA_COPYRIGHT "${PROJECT_SOURCE_DIR}/cmake/package/copyright")
include(CPack)
