#include "acquisition/remove_offset.hpp"

#include "acquisition/large_pages.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::acquisition {

double baseline(const Eigen::VectorXd& channel,
                Eigen::Index begin,
                Eigen::Index pre_trigger) {
  const Eigen::Index first = std::clamp<Eigen::Index>(begin, 0, channel.size());
  const Eigen::Index count =
      std::min<Eigen::Index>(pre_trigger, channel.size() - first);
  if (count <= 0) return median(channel);
  return channel.segment(first, count).mean();
}

double median(Eigen::VectorXd values) {
  if (values.size() == 0) return 0.0;
  double* middle = values.data() + values.size() / 2;
  std::nth_element(values.data(), middle, values.data() + values.size());
  return *middle;
}

Eigen::VectorXd thinned(const Eigen::Ref<const Eigen::VectorXd>& values,
                        Eigen::Index most) {
  const Eigen::Index n = values.size();
  if (n <= most) return values;
  // 7919 is prime, so its multiples wander through a part. Parts are `least`
  // or one more long; the multiples modulo either are added up, since a
  // division takes longer than all else here.
  const Eigen::Index least = n / most;
  const Eigen::Index rest = n % most;
  const Eigen::Index steps[] = {7919 % least, 7919 % (least + 1)};
  Eigen::Index wander[] = {0, 0};
  Eigen::Index from = 0;
  Eigen::Index over = 0;  // k n modulo `most`
  Eigen::VectorXd result(most);
  for (Eigen::Index k = 0; k < most; ++k) {
    over += rest;
    const bool longer = over >= most;
    if (longer) over -= most;
    result[k] = values[from + wander[longer ? 1 : 0]];
    from += least + (longer ? 1 : 0);
    for (Eigen::Index j = 0; j < 2; ++j) {
      wander[j] += steps[j];
      if (wander[j] >= least + j) wander[j] -= least + j;
    }
  }
  return result;
}

Driftless without_drift(const Eigen::Ref<const Eigen::VectorXd>& channel,
                        Eigen::Index segment) {
  constexpr Eigen::Index enough = 512;
  const Eigen::Index n = channel.size();
  const Eigen::Index count = std::max<Eigen::Index>(1, n / segment);
  const double length = static_cast<double>(n) / static_cast<double>(count);
  Eigen::VectorXd medians(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index from = k * n / count;
    const Eigen::Index to = (k + 1) * n / count;
    medians[k] = median(thinned(channel.segment(from, to - from), enough));
  }
  // Straight lines between the segments' middles, level before the first one
  // and after the last one.
  Driftless driftless;
  Eigen::VectorXd& result = driftless.values;
  result.resize(n);
  prefer_large_pages(result);
  Eigen::Index i = 0;
  for (Eigen::Index next = 0; next <= count; ++next) {
    const Eigen::Index left = std::max<Eigen::Index>(0, next - 1);
    const Eigen::Index right = std::min(next, count - 1);
    const double middle = (static_cast<double>(left) + 0.5) * length;
    const double slope = (medians[right] - medians[left]) / length;
    const Eigen::Index end =
        next == count
            ? n
            : std::min(n,
                       static_cast<Eigen::Index>(std::ceil(
                           (static_cast<double>(next) + 0.5) * length)));
    for (; i < end; ++i) {
      result[i] = channel[i] - medians[left] -
                  slope * (static_cast<double>(i) - middle);
    }
    // While they are in the cache.
    const Eigen::Index known = piece_length * std::ssize(driftless.pieces);
    const Eigen::Index whole = end == n ? n : i - i % piece_length;
    if (whole <= known) continue;
    for (const Range& piece :
         piece_ranges(result.segment(known, whole - known))) {
      driftless.pieces.push_back(piece);
    }
  }
  return driftless;
}

}  // namespace tapfit::acquisition
