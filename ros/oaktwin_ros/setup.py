from glob import glob

from setuptools import find_packages, setup

NAME = "oaktwin_ros"

setup(
    name=NAME,
    version="0.1.0",
    packages=find_packages(),
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
        (f"share/{NAME}", ["package.xml"]),
        (f"share/{NAME}/launch", glob("launch/*.launch.py")),
        (f"share/{NAME}/config", glob("config/*.yaml")),
    ],
    install_requires=["setuptools", "numpy", "oaktwin"],
    zip_safe=True,
    maintainer="The oaktwin authors",
    maintainer_email="oaktwin@users.noreply.github.com",
    description="A filter that turns a simulator's exact depth into what an OAK depth camera would report",
    license="MIT OR Apache-2.0",
    entry_points={"console_scripts": [f"filter = {NAME}.filter_node:main"]},
)
