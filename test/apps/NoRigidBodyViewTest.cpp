// SPDX-License-Identifier: BSD-3-Clause
// specplan plan --html where the command was built without three.js.
#include <gtest/gtest.h>

#include "Command.h"

namespace specplan::test
{
namespace
{
TEST(NoRigidBodyView, SaysWhatItWasBuiltWithout)
{
    const TemporaryFolder folder;
    const Outcome outcome = call("plan '" + scene("office.cfg") + "' --html '" + folder / "a.html" + "'");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err,
              "specplan: --html needs three.js (package libjs-three), which was not there when specplan was built\n");
    EXPECT_EQ(folder.files(), 0);
}
}  // namespace
}  // namespace specplan::test
