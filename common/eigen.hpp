#pragma once

/// Eigen's matrices, as every header of this project includes them: with a check that memory is aligned as in the
/// project's own libraries. With AVX (-mavx, -march=native) Eigen allocates otherwise, and a matrix that one side
/// allocated and the other frees ends the process.

#include <Eigen/Core>

#if EIGEN_MAX_ALIGN_BYTES != 16
#error \
    "Eigen aligns memory otherwise than in evbal's libraries: compile with -DEIGEN_MAX_ALIGN_BYTES=16, or without -mavx or -march=native"
#endif
