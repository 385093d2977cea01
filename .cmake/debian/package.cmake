# `cpack` makes two packages for the Debian that it runs on: tetproof, and tetproof-dev for find_package(tetproof).
# They hold whatever `cmake --install` installs: layout.cmake tells what of it is for tetproof-dev.
cmake_host_system_information(RESULT distribution QUERY DISTRIB_ID)
cmake_host_system_information(RESULT release QUERY DISTRIB_VERSION_ID)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME tetproof)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")   # each package has its own
set(CPACK_PACKAGE_CONTACT "The authors of tetproof <tetproof@authors.invalid>" CACHE STRING "Who answers for packages: NAME <ADDRESS>")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_COMPONENTS_ALL tetproof dev)
install(CODE "" COMPONENT dev)   # empty until layout.cmake fills it
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS   # whatever the umask
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PROJECT_CONFIG_FILE "${PROJECT_SOURCE_DIR}/.cmake/debian/needs.cmake")
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/.cmake/debian/layout.cmake")
set(CPACK_TETPROOF_SOURCE "${PROJECT_SOURCE_DIR}")   # for the two scripts

# A package for Debian 12 does not fit 13: its libraries have other names there. The version says which one it is for.
set(CPACK_DEBIAN_PACKAGE_VERSION "${PROJECT_VERSION}")
if(distribution MATCHES "^(debian|ubuntu)$")
  string(REPLACE "debian" "deb" distribution "${distribution}")
  string(APPEND CPACK_DEBIAN_PACKAGE_VERSION "+${distribution}${release}")
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_TETPROOF_PACKAGE_NAME tetproof)
set(CPACK_DEBIAN_TETPROOF_PACKAGE_SECTION math)
set(CPACK_DEBIAN_TETPROOF_DESCRIPTION "correctness oracle for tetrahedral meshes
tetproof-verify decides exactly whether a tetrahedral mesh is a valid
triangulation of a solid, and whether it fills a surface. tetproof-fuzz
runs a mesher on random surfaces and judges what it writes.
tetproof-convert converts between mesh formats without losing a double.
tetproof-mesh is a reference implementation of the method of Hamann, Chen
and Hong (1994), and tetproof-compare compares implementations of it.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME tetproof-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_DESCRIPTION "C++ libraries and headers of tetproof
The judge, the readers and writers of mesh formats, the reference
implementation and the fuzzer as libraries, with a CMake package:
find_package(tetproof) provides tetproof::verify, tetproof::io,
tetproof::reference and tetproof::corpus.")
# What tetproofConfig.cmake looks for, and what the libraries are linked with.
string(JOIN ", " CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "tetproof (= ${CPACK_DEBIAN_PACKAGE_VERSION})"
  libeigen3-dev libfmt-dev libgmp-dev liblz4-dev liblzma-dev libmpfr-dev libpugixml-dev libtbb-dev zlib1g-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "libgmock-dev, librapidcheck-dev")
include(CPack)
