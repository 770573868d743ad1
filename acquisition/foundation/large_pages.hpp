// Memory for many samples in large pages.
//
// A page is brought in when it is first written to; with 4 KB pages that takes
// as long as decoding the samples that go there. Linux gives 2 MB ones where it
// is asked to (madvise(2), MADV_HUGEPAGE).
#pragma once

#include <Eigen/Core>

namespace tapfit::acquisition {

/// Asks for large pages under a matrix that has not been written to yet. Only
/// a wish: small or unwilling systems leave everything as it is.
void prefer_large_pages(Eigen::Ref<Eigen::MatrixXd> samples);

}  // namespace tapfit::acquisition
