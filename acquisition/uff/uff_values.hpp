// The values of a function of a universal file (dataset 58 or 58b), piece by
// piece: a record may be larger than memory.
#pragma once

#include "acquisition/uff/uff_datasets.hpp"
#include "acquisition/uff/uff_function.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::acquisition {

/// Walks through a real function over an even abscissa.
class UffValues {
 public:
  /// @param dataset and the file behind it have to outlive this object
  /// @param header of it, real and even
  UffValues(const UffDataset& dataset, const UffHeader& header);

  /// The next values, as many as `values` has room for, fewer at the end.
  ///
  /// @throws InputError for fewer numbers than announced, text that is none
  Eigen::Index read(Eigen::Ref<Eigen::VectorXd> values);

  /// The part of the file that the last read() went through.
  [[nodiscard]] std::string_view passed() const { return passed_; }

 private:
  Eigen::Index read_text(Eigen::Ref<Eigen::VectorXd> values);
  Eigen::Index read_bytes(Eigen::Ref<Eigen::VectorXd> values);

  const UffDataset* dataset_;
  bool is_double_;
  Eigen::Index count_;
  Eigen::Index done_ = 0;
  std::size_t at_ = 0;        ///< in the data
  int line_ = 0;              ///< of the data
  std::vector<double> rest_;  ///< of the last line, not given out yet
  std::size_t given_ = 0;     ///< of these
  std::string_view passed_;
};

}  // namespace tapfit::acquisition
