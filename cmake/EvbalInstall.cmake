# What `cmake --install build/release --prefix P` adds to the rooms and programs: the shipped cities, schedules of
# faults, scenarios and sweeps, examples, pages, and what find_package(evbal) reads. The build tree has its share/evbal
# too, since programs look for it above themselves.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/evbal)
foreach(shipped benchmarks cities faults scenarios studies)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/experiments/${shipped} ${PROJECT_BINARY_DIR}/share/evbal/${shipped} SYMBOLIC)
  install(DIRECTORY experiments/${shipped} DESTINATION share/evbal)
endforeach()
install(DIRECTORY examples DESTINATION share/evbal PATTERN nearest.py EXCLUDE)
install(PROGRAMS examples/nearest.py DESTINATION share/evbal/examples)
install(FILES tools/deb/completion.bash DESTINATION share/bash-completion/completions RENAME evbal)

# The guides lie as in the tree, so that they find each other and what they speak of.
set(guides share/doc/evbal)
install(FILES CHANGELOG.md CITATION.cff CONTRIBUTING.md LICENSE NOTICE README.md SECURITY.md DESTINATION ${guides})
install(DIRECTORY docs DESTINATION ${guides} FILES_MATCHING REGEX "[.](md|png|svg)$")
install(FILES tools/packages-deb.txt tools/packages-run.txt tools/packages-test.txt DESTINATION ${guides}/tools)
install(FILES tools/gps/san-francisco.yaml DESTINATION ${guides}/tools/gps)
install(DIRECTORY tools/ingest DESTINATION ${guides}/tools FILES_MATCHING PATTERN *.yaml)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/links)
file(CREATE_LINK ../../evbal ${PROJECT_BINARY_DIR}/links/experiments SYMBOLIC)
install(FILES ${PROJECT_BINARY_DIR}/links/experiments DESTINATION ${guides})

# Manual pages, where there is help2man.
find_program(HELP2MAN help2man)
if(HELP2MAN)
  set(manual ${PROJECT_BINARY_DIR}/share/man/man1)
  set(pages_maker ${PROJECT_SOURCE_DIR}/tools/deb/make-pages)
  add_custom_command(OUTPUT ${manual}/evbal.1.gz COMMAND ${pages_maker} $<TARGET_FILE:evbal> ${manual}
    DEPENDS evbal ${pages_maker} ${PROJECT_SOURCE_DIR}/tools/deb/sections.h2m)
  add_custom_target(manual ALL DEPENDS ${manual}/evbal.1.gz)
  install(DIRECTORY ${manual} DESTINATION share/man)
endif()

evbal_install(evbal_eigen evbal_mrpt_math evbal_mrpt_system evbal_mrpt_bayes evbal_ipopt evbal_clp evbal_lapack evbal_nlopt)
include(CMakePackageConfigHelpers)
set(package_folder lib/cmake/evbal)
install(EXPORT evbal NAMESPACE evbal:: FILE evbalTargets.cmake DESTINATION ${package_folder} COMPONENT dev)
configure_file(cmake/evbalConfig.cmake.in evbalConfig.cmake @ONLY)
write_basic_package_version_file(evbalConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/evbalConfig.cmake ${PROJECT_BINARY_DIR}/evbalConfigVersion.cmake DESTINATION ${package_folder} COMPONENT dev)
