# Packages for Debian, made by `cpack` (tools/package): evbal to play days, 200 MB with what it needs; evbal-dev to build
# controllers on its libraries, 670 MB more, since that takes a compiler and the headers of all dependencies; python3-evbal
# to step days from Python.

# Debian wants for each package: its changes, compressed, and whose it is on what terms. the others share evbal's folder.
set(deb ${PROJECT_BINARY_DIR}/deb)
file(MAKE_DIRECTORY ${deb})
set(copyright ${PROJECT_SOURCE_DIR}/tools/deb/copyright /usr/share/doc/node-d3/copyright /usr/share/doc/coinor-libipopt-dev/copyright)
add_custom_command(OUTPUT ${deb}/changelog.gz ${deb}/copyright
  COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md > ${deb}/changelog.gz
  COMMAND cat ${copyright} > ${deb}/copyright
  DEPENDS ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${copyright})
add_custom_target(deb ALL DEPENDS ${deb}/changelog.gz ${deb}/copyright)
file(CREATE_LINK evbal ${deb}/evbal-dev SYMBOLIC)
install(FILES ${deb}/changelog.gz ${deb}/copyright DESTINATION share/doc/evbal)
install(FILES ${deb}/evbal-dev DESTINATION share/doc COMPONENT dev)
if(TARGET evbal-python)
  file(CREATE_LINK evbal ${deb}/python3-evbal SYMBOLIC)
  install(FILES ${deb}/python3-evbal DESTINATION share/doc COMPONENT python)
endif()

# What building takes of the packages to build and run.
file(STRINGS tools/packages-run.txt needed_to_build REGEX "-dev$|^(cmake|g[+][+]|ninja-build|pkgconf)$")
list(JOIN needed_to_build ", " needed_to_build)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGE_CONTACT "The evbal authors")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_EVBAL_PACKAGE_NAME evbal)
set(CPACK_DEBIAN_EVBAL_DESCRIPTION
  "A city's regions are agents that hold taxis, passengers and chargers. A coordinator plans where taxis go, faults are
injected on purpose, and the record shows how each controller did. Begin with: evbal run toy.yaml")
set(CPACK_DEBIAN_EVBAL_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_EVBAL_PACKAGE_DEPENDS libopenblas0-serial)  # with another BLAS digests may differ
set(CPACK_DEBIAN_EVBAL_PACKAGE_SUGGESTS "coinor-csdp, evbal-dev, node-jsdom, nodejs, slurm-client")
set(CPACK_DEBIAN_DEV_DESCRIPTION
  "Libraries, headers and a CMake package, to build controllers and tools of one's own on evbal.")
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "evbal (= ${PROJECT_VERSION}), ${needed_to_build}")
math(EXPR next_python "${Python3_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-evbal)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION
  "The Python package evbal: days of the fleet as environments to learn in, runs and sweeps as arrays.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "evbal (= ${PROJECT_VERSION}), python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_python}), python3-numpy")
include(CPack)
