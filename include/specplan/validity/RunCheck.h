// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "specplan/validity/Executor.h"

namespace specplan::validity
{
/// Seconds on the steady clock.
[[nodiscard]] double steadySeconds() noexcept;

/// Seconds of processor time that the calling thread has had.
[[nodiscard]] double threadCpuSeconds() noexcept;

/// Runs one check, measures it, and catches what it throws.
[[nodiscard]] Completion runCheck(Checker& checker, CheckId check, unsigned worker) noexcept;

/// The same without reading the clock: `seconds` is 0.
[[nodiscard]] Completion runCheckUnmeasured(Checker& checker, CheckId check, unsigned worker) noexcept;
}  // namespace specplan::validity
