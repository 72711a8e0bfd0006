// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

/// Instead of registering the class: a function that makes one.
#define PLUGINLIB_EXPORT_CLASS(Class, Base) \
    std::unique_ptr<Base> makePlugin();     \
    std::unique_ptr<Base> makePlugin()      \
    {                                       \
        return std::make_unique<Class>();   \
    }
