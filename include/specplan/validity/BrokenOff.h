// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace specplan::validity
{
/// Thrown by a check that was told to stop before it came to a verdict: as if it had not begun.
struct BrokenOff
{
};
}  // namespace specplan::validity
