// SPDX-License-Identifier: BSD-3-Clause
// As much of ROS as the MoveIt plugin names.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace rclcpp
{
class Node
{
public:
    using SharedPtr = std::shared_ptr<Node>;
};

struct Logger
{
    std::string name;
};

inline Logger get_logger(const std::string& name)
{
    return {name};
}

/// What was logged, each line with its level.
inline std::vector<std::string>& logged()
{
    static std::vector<std::string> lines;
    return lines;
}

inline void log(const char* level, const char*, const char*, int, const char* text)
{
    logged().push_back(std::string(level) + ' ' + text);
}
}  // namespace rclcpp

#define RCLCPP_ERROR(logger, ...) (static_cast<void>(logger), rclcpp::log("error", __VA_ARGS__))
#define RCLCPP_WARN(logger, ...) (static_cast<void>(logger), rclcpp::log("warn", __VA_ARGS__))
#define RCLCPP_DEBUG(logger, ...) (static_cast<void>(logger), rclcpp::log("debug", __VA_ARGS__))
