# Every dependency is a Debian package; README.md says why each is there.
find_package(PkgConfig REQUIRED)
find_package(yaml-cpp REQUIRED)
pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET libxxhash)

# Debian ships Eigen and Random123 as headers; SYSTEM keeps their warnings out of ours.
find_path(EIGEN_INCLUDE_DIR Eigen/Core PATH_SUFFIXES eigen3 REQUIRED)
add_library(evbal_eigen INTERFACE)
add_library(evbal::eigen ALIAS evbal_eigen)
target_include_directories(evbal_eigen SYSTEM INTERFACE ${EIGEN_INCLUDE_DIR})

# MRPT's headers do not pass our warnings.
find_package(mrpt-math REQUIRED)
add_library(evbal_mrpt_math INTERFACE)
add_library(evbal::mrpt_math ALIAS evbal_mrpt_math)
target_link_libraries(evbal_mrpt_math INTERFACE mrpt::math)

find_package(CLI11 REQUIRED)
find_package(SQLiteCpp REQUIRED)
find_package(nlohmann_json REQUIRED)
# The bus. The generator of its types is a Java program whose package does not pull in a Java runtime.
find_package(fastcdr REQUIRED)
find_package(fastrtps REQUIRED)
find_program(FASTDDSGEN fastddsgen REQUIRED)
find_program(JAVA java REQUIRED)
