#pragma once

#include <array>
#include <utility>

namespace evbal {

/// The environment under which libraries that choose their code by the processor all choose the same: one BLAS
/// thread, OpenBLAS's kernels for the oldest processor it knows, the C library's mathematics without AVX and FMA.
inline constexpr std::array<std::pair<const char*, const char*>, 4> pinned_environment{{
    {"OPENBLAS_NUM_THREADS", "1"},
    {"OMP_NUM_THREADS", "1"},
    {"OPENBLAS_CORETYPE", "Nehalem"},
    {"GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4"},
}};

/// Starts this program again, once, under that environment, since those choices are made before main; children
/// inherit it. First thing in every main, for results to be the same bytes on every x86-64 machine. Under an emulator
/// in user mode, which a new start would leave, set the environment outside:
/// `env OPENBLAS_NUM_THREADS=1 ... qemu-x86_64 -cpu Nehalem evbal ...`.
void pin_arithmetic(char** argv);

}  // namespace evbal
