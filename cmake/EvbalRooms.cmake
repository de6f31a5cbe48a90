# How a room (one folder, one library) is built: warnings on, no fused or reordered floating point (results replay to
# the byte), includes from the root of the tree. Whoever uses an installed room gets all of this but the warnings.

add_library(evbal_options INTERFACE)
target_include_directories(evbal_options INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/evbal>)
target_compile_features(evbal_options INTERFACE cxx_std_20)
target_compile_options(evbal_options INTERFACE
  $<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion;-Wno-sign-conversion;$<$<BOOL:${EVBAL_WARNINGS_AS_ERRORS}>:-Werror>> -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(evbal_options INTERFACE $<BUILD_INTERFACE:-Wno-restrict>)  # false alarms on std::string's + (GCC bug 105651)
endif()
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(evbal_options INTERFACE $<BUILD_INTERFACE:-Wno-subobject-linkage>)  # takes each source for a header
endif()
if(EVBAL_SANITIZE)
  target_compile_options(evbal_options INTERFACE -fsanitize=${EVBAL_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(evbal_options INTERFACE $<BUILD_INTERFACE:-Wno-maybe-uninitialized>)  # false alarms on sanitized code
  endif()
  if(EVBAL_SANITIZE MATCHES undefined)
    # AddressSanitizer stops at such pointers too; without these checks the build takes three quarters of the time.
    target_compile_options(evbal_options INTERFACE -fno-sanitize=null,alignment,object-size)
  endif()
  target_link_options(evbal_options INTERFACE -fsanitize=${EVBAL_SANITIZE})
endif()

# evbal_install(target...): installs libraries, evbal_name as evbal::name.
function(evbal_install)
  foreach(target IN LISTS ARGN)
    string(REGEX REPLACE "^evbal_" "" name ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
    install(TARGETS ${target} EXPORT evbal COMPONENT dev)
  endforeach()
endfunction()
evbal_install(evbal_options)

# evbal_library(name SOURCES ... [PUBLIC libs...] [PRIVATE libs...]): a static library evbal::name, installed with the
# headers of its folder. The Python module is a shared library that holds it; no other's functions take the place of ours
# there, so that they are compiled as well as for a program.
function(evbal_library name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(evbal_${name} STATIC ${ROOM_SOURCES})
  add_library(evbal::${name} ALIAS evbal_${name})
  target_link_libraries(evbal_${name} PUBLIC evbal_options ${ROOM_PUBLIC} PRIVATE ${ROOM_PRIVATE})
  set_target_properties(evbal_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(evbal_${name} PRIVATE -fno-semantic-interposition)
  evbal_install(evbal_${name})
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  file(GLOB headers CONFIGURE_DEPENDS *.hpp)
  install(FILES ${headers} DESTINATION include/evbal/${folder} COMPONENT dev)
endfunction()

# evbal_program(name SOURCES ... LIBS ...): an executable in bin/, of the build tree as when installed; the target
# `programs` builds them all.
add_custom_target(programs)
function(evbal_program name)
  cmake_parse_arguments(PROGRAM "" "" "SOURCES;LIBS" ${ARGN})
  add_executable(${name} ${PROGRAM_SOURCES})
  target_link_libraries(${name} PRIVATE evbal_options ${PROGRAM_LIBS})
  add_dependencies(programs ${name})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  install(TARGETS ${name})
endfunction()
