#include "acquisition/remove_offset.hpp"

#include <algorithm>

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

Eigen::VectorXd without_drift(const Eigen::VectorXd& channel,
                              Eigen::Index segment) {
  const Eigen::Index n = channel.size();
  const Eigen::Index count = std::max<Eigen::Index>(1, n / segment);
  const double length = static_cast<double>(n) / static_cast<double>(count);
  Eigen::VectorXd medians(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index from = k * n / count;
    const Eigen::Index to = (k + 1) * n / count;
    medians[k] = median(channel.segment(from, to - from));
  }
  Eigen::VectorXd result(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double at = std::clamp(static_cast<double>(i) / length - 0.5,
                                 0.0,
                                 static_cast<double>(count - 1));
    const auto left = static_cast<Eigen::Index>(at);
    const Eigen::Index right = std::min(left + 1, count - 1);
    const double part = at - static_cast<double>(left);
    result[i] =
        channel[i] - (1.0 - part) * medians[left] - part * medians[right];
  }
  return result;
}

}  // namespace tapfit::acquisition
