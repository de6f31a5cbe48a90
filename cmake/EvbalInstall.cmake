# What `cmake --install build/release --prefix P` adds to the rooms and programs: the shipped cities, schedules of
# faults, scenarios and sweeps, and what find_package(evbal) reads. The build tree has its share/evbal too, since
# programs look for it above themselves.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/evbal)
foreach(shipped cities faults scenarios studies)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/experiments/${shipped} ${PROJECT_BINARY_DIR}/share/evbal/${shipped} SYMBOLIC)
  install(DIRECTORY experiments/${shipped} DESTINATION share/evbal)
endforeach()

install(FILES LICENSE NOTICE docs/data-licences.md DESTINATION share/doc/evbal)

evbal_install(evbal_eigen evbal_mrpt_math evbal_ipopt evbal_clp evbal_lapack evbal_nlopt)
include(CMakePackageConfigHelpers)
set(package_folder lib/cmake/evbal)
install(EXPORT evbal NAMESPACE evbal:: FILE evbalTargets.cmake DESTINATION ${package_folder})
configure_file(cmake/evbalConfig.cmake.in evbalConfig.cmake @ONLY)
write_basic_package_version_file(evbalConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/evbalConfig.cmake ${PROJECT_BINARY_DIR}/evbalConfigVersion.cmake DESTINATION ${package_folder})
