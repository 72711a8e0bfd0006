// SPDX-License-Identifier: BSD-3-Clause
// As much of MoveIt as the plugin names; names and signatures are MoveIt's.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <rclcpp/rclcpp.hpp>

namespace moveit::core
{
class RobotModel
{
};
using RobotModelConstPtr = std::shared_ptr<const RobotModel>;
}  // namespace moveit::core

namespace planning_scene
{
class PlanningScene
{
};
using PlanningSceneConstPtr = std::shared_ptr<const PlanningScene>;
}  // namespace planning_scene

namespace moveit_msgs::msg
{
struct MoveItErrorCodes
{
    int val = 0;
};

struct MotionPlanRequest
{
    struct
    {
        std::vector<int> constraints;
    } trajectory_constraints;
};
}  // namespace moveit_msgs::msg

namespace planning_interface
{
using MotionPlanRequest = moveit_msgs::msg::MotionPlanRequest;

struct PlannerConfigurationSettings
{
    std::string group;
    std::string name;
    std::map<std::string, std::string> config;
};
using PlannerConfigurationMap = std::map<std::string, PlannerConfigurationSettings>;

class PlanningContext
{
public:
    virtual ~PlanningContext() = default;
};
using PlanningContextPtr = std::shared_ptr<PlanningContext>;

class PlannerManager
{
public:
    virtual ~PlannerManager() = default;

    virtual bool initialize(const moveit::core::RobotModelConstPtr& model, const rclcpp::Node::SharedPtr& node,
                            const std::string& parameter_namespace) = 0;
    virtual std::string getDescription() const = 0;
    virtual void getPlanningAlgorithms(std::vector<std::string>& algs) const = 0;
    virtual PlanningContextPtr getPlanningContext(const planning_scene::PlanningSceneConstPtr& planning_scene,
                                                  const MotionPlanRequest& req,
                                                  moveit_msgs::msg::MoveItErrorCodes& error_code) const = 0;
    virtual bool canServiceRequest(const MotionPlanRequest& req) const = 0;

    virtual void setPlannerConfigurations(const PlannerConfigurationMap& pcs)
    {
        config_settings_ = pcs;
    }

    const PlannerConfigurationMap& getPlannerConfigurations() const
    {
        return config_settings_;
    }

protected:
    PlannerConfigurationMap config_settings_;
};
}  // namespace planning_interface
