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
find_package(nlohmann_json REQUIRED)
find_package(SQLiteCpp REQUIRED)

# The bus: Fast DDS 3 is named fastdds, 2 fastrtps.
find_package(fastcdr REQUIRED)
find_package(fastdds QUIET)
if(fastdds_FOUND)
  set(fast_dds fastdds)
else()
  find_package(fastrtps REQUIRED)
  set(fast_dds fastrtps)
endif()

# COIN-OR ships no CMake configuration. Ipopt 3.11.9 includes <cstddef> only if it is told that there is one.
# Debian 13's shared libipopt is linked to a MUMPS with Open MPI, which catches signals as soon as it is loaded and leaves
# files in /tmp and /dev/shm. So the static one is taken there, with the MUMPS that needs no MPI, as Debian 12's shared one
# is; Debian 12's static one cannot be part of the Python module.
find_path(IPOPT_INCLUDE_DIR IpTNLP.hpp PATH_SUFFIXES coin-or coin REQUIRED)
pkg_check_modules(IPOPT REQUIRED ipopt)
if(IPOPT_VERSION VERSION_LESS 3.14)
  find_library(IPOPT_LIBRARY ipopt REQUIRED)
else()
  find_library(IPOPT_LIBRARY libipopt.a REQUIRED)
endif()
find_library(MUMPS_LIBRARY dmumps_seq REQUIRED)
find_library(LAPACK_LIBRARY lapack REQUIRED)
find_library(BLAS_LIBRARY blas REQUIRED)
find_path(CLP_INCLUDE_DIR ClpSimplex.hpp PATH_SUFFIXES coin REQUIRED)
find_library(CLP_LIBRARY Clp REQUIRED)
find_library(COINUTILS_LIBRARY CoinUtils REQUIRED)
add_library(evbal_ipopt INTERFACE)
add_library(evbal::ipopt ALIAS evbal_ipopt)
target_include_directories(evbal_ipopt SYSTEM INTERFACE ${IPOPT_INCLUDE_DIR})
target_compile_definitions(evbal_ipopt INTERFACE HAVE_CSTDDEF)
target_link_libraries(evbal_ipopt INTERFACE ${IPOPT_LIBRARY} ${MUMPS_LIBRARY} ${LAPACK_LIBRARY} ${BLAS_LIBRARY})
add_library(evbal_clp INTERFACE)
add_library(evbal::clp ALIAS evbal_clp)
target_include_directories(evbal_clp SYSTEM INTERFACE ${CLP_INCLUDE_DIR})
target_link_libraries(evbal_clp INTERFACE ${CLP_LIBRARY} ${COINUTILS_LIBRARY})
add_library(evbal_lapack INTERFACE)
add_library(evbal::lapack ALIAS evbal_lapack)
target_link_libraries(evbal_lapack INTERFACE ${LAPACK_LIBRARY})
find_package(LibArchive REQUIRED)
find_path(NLOPT_INCLUDE_DIR nlopt.h REQUIRED)
find_library(NLOPT_LIBRARY nlopt REQUIRED)
add_library(evbal_nlopt INTERFACE)
add_library(evbal::nlopt ALIAS evbal_nlopt)
target_include_directories(evbal_nlopt SYSTEM INTERFACE ${NLOPT_INCLUDE_DIR})
target_link_libraries(evbal_nlopt INTERFACE ${NLOPT_LIBRARY})
pkg_check_modules(shapelib REQUIRED IMPORTED_TARGET shapelib)
pkg_check_modules(proj REQUIRED IMPORTED_TARGET proj)
