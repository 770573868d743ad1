#include "updating/reduction/base_cache.hpp"

#include "updating/cache/program_stamp.hpp"

#include <algorithm>
#include <string>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

bool is_of_size(const MatrixXd& matrix, Index rows, Index columns) {
  return matrix.rows() == rows && matrix.cols() == columns;
}

std::optional<Digest> base_key(const BaseContent& content) {
  const std::optional<std::string> stamp = program_stamp();
  if (!stamp) return std::nullopt;
  ContentDigest digest;
  digest.add("reduced base");
  digest.add(*stamp);
  digest.add(content.system.K);
  digest.add(content.system.M);
  digest.add(content.system.fixed);
  digest.add(content.system.inactive);
  digest.add(content.system.T);
  for (const MassForm& form : content.forms) {
    digest.add(form.M);
  }
  for (const UncertainPart& part : content.parts) {
    digest.add(part.power);
    digest.add(part.K);
    digest.add(part.M);
  }
  digest.add(content.points);
  digest.add(content.high_hz);
  digest.add(content.reach);
  return digest.digest();
}

// In the order of store_base().
std::optional<SolvedBase> load_base(const MatrixCache& cache,
                                    const Digest& key,
                                    const BaseContent& content) {
  std::optional<std::vector<MatrixXd>> kept = cache.load(key);
  const std::size_t parts = content.parts.size();
  if (!kept || kept->size() != 5 + 2 * parts) return std::nullopt;
  std::vector<MatrixXd>& m = *kept;
  const Index count = m[0].rows();
  const Index n = content.system.dofs();
  const Index size = m[3].rows();
  const bool fits =
      is_of_size(m[0], count, 1) && is_of_size(m[1], content.free, count) &&
      is_of_size(m[2], n, size) && is_of_size(m.back(), 1, 1) &&
      std::all_of(m.begin() + 3, m.end() - 1, [size](const MatrixXd& reduced) {
        return is_of_size(reduced, size, size);
      });
  if (!fits) return std::nullopt;
  SolvedBase solved;
  solved.modes_hz = m[0].col(0);
  solved.modes = std::move(m[1]);
  solved.V = std::move(m[2]);
  solved.K = std::move(m[3]);
  for (std::size_t k = 0; k < parts; ++k) {
    solved.K_part.push_back(std::move(m[4 + k]));
    solved.M_part.push_back(std::move(m[4 + parts + k]));
  }
  solved.error = m.back()(0, 0);
  return solved;
}

void store_base(const MatrixCache& cache,
                const Digest& key,
                const SolvedBase& solved) {
  std::vector<MatrixXd> all = {
      solved.modes_hz, solved.modes, solved.V, solved.K};
  all.insert(all.end(), solved.K_part.begin(), solved.K_part.end());
  all.insert(all.end(), solved.M_part.begin(), solved.M_part.end());
  all.push_back(MatrixXd::Constant(1, 1, solved.error));
  cache.store(key, all);
}

}  // namespace

SolvedBase kept_or_solved(const std::optional<MatrixCache>& cache,
                          const BaseContent& content,
                          const std::function<SolvedBase()>& solve) {
  const std::optional<Digest> key = cache ? base_key(content) : std::nullopt;
  if (!key) return solve();
  std::optional<SolvedBase> kept = load_base(*cache, *key, content);
  if (kept) return std::move(*kept);
  SolvedBase solved = solve();
  store_base(*cache, *key, solved);
  return solved;
}

}  // namespace tapfit::updating
