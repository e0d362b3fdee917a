"""Starts the filter: ros2 launch oaktwin_ros filter.launch.py model:=OAK4-D depth:=/camera/depth_image"""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

ARGUMENTS = {
    "model": "OAK-D-Pro-PoE",
    "depth": "/camera/depth/image_raw",
    "info": "/camera/camera_info",
    "namespace": "",
}


def generate_launch_description() -> LaunchDescription:
    parameters = PathJoinSubstitution([FindPackageShare("oaktwin_ros"), "config", "filter.yaml"])
    declared = [DeclareLaunchArgument(name, default_value=default) for name, default in ARGUMENTS.items()]
    declared.append(DeclareLaunchArgument("parameters", default_value=parameters))
    node = Node(
        package="oaktwin_ros",
        executable="filter",
        namespace=LaunchConfiguration("namespace"),
        parameters=[LaunchConfiguration("parameters"), {"model": LaunchConfiguration("model")}],
        remappings=[
            ("camera/depth/image_raw", LaunchConfiguration("depth")),
            ("camera/camera_info", LaunchConfiguration("info")),
        ],
        output="screen",
    )
    return LaunchDescription([*declared, node])
