#include "acquisition/range.hpp"

#include <algorithm>

namespace tapfit::acquisition {

Range range_of(const Eigen::Ref<const Eigen::VectorXd>& x) {
  // Eight at a time, so that the processor need not wait for the one before.
  using Eight = Eigen::Array<double, 8, 1>;
  Range range;
  Eight low = Eight::Constant(range.low);
  Eight high = Eight::Constant(range.high);
  const Eigen::Index n = x.size();
  Eigen::Index i = 0;
  for (; i + 8 <= n; i += 8) {
    const Eigen::Map<const Eight> values(x.data() + i);
    low = low.min(values);
    high = high.max(values);
  }
  range = {low.minCoeff(), high.maxCoeff()};
  for (; i < n; ++i) {
    range.low = std::min(range.low, x[i]);
    range.high = std::max(range.high, x[i]);
  }
  return range;
}

}  // namespace tapfit::acquisition
