#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/retrieval/positive_definite_inverse.h"

namespace shapegauge {

namespace {

/// A symmetric positive definite matrix: its diagonal exceeds the sum of the rest of a row.
Eigen::MatrixXd positive_definite(Eigen::Index size) {
  RandomNumbers random(7);
  Eigen::MatrixXd matrix(size, size);
  for (double& entry : matrix.reshaped()) entry = random.uniform(-1, 1);
  Eigen::MatrixXd symmetric = (matrix + matrix.transpose()) / 2;
  symmetric.diagonal().array() += static_cast<double>(size);
  return symmetric;
}

TEST(PositiveDefiniteInverse, IsEigensToTheBit) {
  for (const Eigen::Index size : {1, 3, 31, 32, 65, 129, 300, 517}) {
    const Eigen::MatrixXd matrix = positive_definite(size);
    const Eigen::MatrixXd expected = matrix.llt().solve(Eigen::MatrixXd::Identity(size, size));
    EXPECT_EQ(positive_definite_inverse(matrix), expected) << size;
    EXPECT_TRUE((expected * matrix).isIdentity(1e-9)) << size;
  }
}

TEST(PositiveDefiniteInverse, CanBeInterrupted) {
  Cancellation cancellation;
  EXPECT_THROW(cancellation.run([&] {
    cancellation.cancel();
    positive_definite_inverse(positive_definite(100));
    FAIL();
  }),
               Interrupted);
}

}  // namespace

}  // namespace shapegauge
