// SPDX-License-Identifier: BSD-3-Clause
// Without OctoMap its files are refused, and everything else goes on.
#include <gtest/gtest.h>

#include "RigidFixture.h"
#include "specplan/problems/InputError.h"
#include "specplan/problems/fcl/OctoMap.h"

namespace specplan::problems
{
namespace
{
TEST(OctoMap, IsRefusedInOneLineWhereItIsMissing)
{
    const test::TemporaryFolder folder;
    const std::string file = folder.write("a.bt", "# Octomap OcTree binary file\n");
    EXPECT_FALSE(hasOctoMap());
    EXPECT_EQ(test::complaintOf<InputError>([&] { static_cast<void>(readOctoMap(file)); }),
              file +
                  ": expected a mesh: specplan was built without OctoMap, which this file needs (FCL built with it, "
                  "and liboctomap-dev)");
}
}  // namespace
}  // namespace specplan::problems
