// The inner loops of Eigen's products of dense matrices, compiled once instead
// of in every file that multiplies (eigen_instances.hpp).
// products.cpp defines what the others declare.
#pragma once

#include <Eigen/Core>

#include <complex>

#ifndef TAPFIT_INSTANCE
#define TAPFIT_INSTANCE extern template
#endif

#define TAPFIT_COMPLEX std::complex<double>

// Matrix times matrix; the flags say which of the two is conjugated.
#define TAPFIT_KERNEL(A, B, ConjA, ConjB)                      \
  TAPFIT_INSTANCE struct gebp_kernel<                          \
      A,                                                       \
      B,                                                       \
      Index,                                                   \
      blas_data_mapper<ScalarBinaryOpTraits<A, B>::ReturnType, \
                       Index,                                  \
                       ColMajor,                               \
                       Unaligned,                              \
                       1>,                                     \
      gebp_traits<A, B>::mr,                                   \
      gebp_traits<A, B>::nr,                                   \
      ConjA,                                                   \
      ConjB>;
#define TAPFIT_PACKING(T, Order)               \
  TAPFIT_INSTANCE struct gemm_pack_lhs<        \
      T,                                       \
      Index,                                   \
      const_blas_data_mapper<T, Index, Order>, \
      gebp_traits<T, T>::mr,                   \
      gebp_traits<T, T>::LhsProgress,          \
      gebp_traits<T, T>::LhsPacket4Packing,    \
      Order>;                                  \
  TAPFIT_INSTANCE struct gemm_pack_rhs<        \
      T,                                       \
      Index,                                   \
      const_blas_data_mapper<T, Index, Order>, \
      gebp_traits<T, T>::nr,                   \
      Order>;
// Matrix times vector.
#define TAPFIT_ON_VECTOR(A, Order, ConjA, B)            \
  TAPFIT_INSTANCE struct general_matrix_vector_product< \
      Index,                                            \
      A,                                                \
      const_blas_data_mapper<A, Index, Order>,          \
      Order,                                            \
      ConjA,                                            \
      B,                                                \
      const_blas_data_mapper<B, Index, ColMajor>,       \
      false,                                            \
      0>;                                               \
  TAPFIT_INSTANCE struct general_matrix_vector_product< \
      Index,                                            \
      A,                                                \
      const_blas_data_mapper<A, Index, Order>,          \
      Order,                                            \
      ConjA,                                            \
      B,                                                \
      const_blas_data_mapper<B, Index, RowMajor>,       \
      false,                                            \
      0>;

namespace Eigen::internal {

TAPFIT_KERNEL(double, double, false, false)
TAPFIT_KERNEL(double, TAPFIT_COMPLEX, false, false)
TAPFIT_KERNEL(TAPFIT_COMPLEX, double, false, false)
TAPFIT_KERNEL(TAPFIT_COMPLEX, double, true, false)
TAPFIT_KERNEL(TAPFIT_COMPLEX, TAPFIT_COMPLEX, false, false)
TAPFIT_KERNEL(TAPFIT_COMPLEX, TAPFIT_COMPLEX, true, false)
TAPFIT_KERNEL(TAPFIT_COMPLEX, TAPFIT_COMPLEX, false, true)
TAPFIT_PACKING(double, ColMajor)
TAPFIT_PACKING(double, RowMajor)
TAPFIT_PACKING(TAPFIT_COMPLEX, ColMajor)
TAPFIT_PACKING(TAPFIT_COMPLEX, RowMajor)
TAPFIT_ON_VECTOR(double, ColMajor, false, double)
TAPFIT_ON_VECTOR(double, RowMajor, false, double)
TAPFIT_ON_VECTOR(double, ColMajor, false, TAPFIT_COMPLEX)
TAPFIT_ON_VECTOR(double, RowMajor, false, TAPFIT_COMPLEX)
TAPFIT_ON_VECTOR(TAPFIT_COMPLEX, ColMajor, false, TAPFIT_COMPLEX)
TAPFIT_ON_VECTOR(TAPFIT_COMPLEX, RowMajor, false, TAPFIT_COMPLEX)
TAPFIT_ON_VECTOR(TAPFIT_COMPLEX, RowMajor, true, TAPFIT_COMPLEX)

}  // namespace Eigen::internal

#undef TAPFIT_KERNEL
#undef TAPFIT_PACKING
#undef TAPFIT_ON_VECTOR
#undef TAPFIT_COMPLEX
#undef TAPFIT_INSTANCE
