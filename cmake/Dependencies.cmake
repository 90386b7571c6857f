# Every package that the build looks for. tools/debian-packages.txt names where each comes from.
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(fastcdr REQUIRED)
find_package(fastrtps REQUIRED)
find_package(GEOS REQUIRED)
find_package(GDAL 3.6 CONFIG REQUIRED)
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
# OMPL's own configuration names libraries that its package does not bring.
find_library(OMPL_LIBRARY ompl REQUIRED)
find_path(OMPL_INCLUDE_DIR ompl/base/spaces/DubinsStateSpace.h PATH_SUFFIXES ompl-1.5 REQUIRED)
add_library(OMPL::ompl UNKNOWN IMPORTED)
set_target_properties(OMPL::ompl PROPERTIES
  IMPORTED_LOCATION ${OMPL_LIBRARY}
  INTERFACE_INCLUDE_DIRECTORIES ${OMPL_INCLUDE_DIR}
  INTERFACE_LINK_LIBRARIES Eigen3::Eigen)
if(BUILD_TESTING)
  find_package(Catch2 2 REQUIRED)
  find_package(benchmark REQUIRED)
  find_library(GLPK_LIBRARY glpk REQUIRED)
  find_path(GLPK_INCLUDE_DIR glpk.h REQUIRED)
endif()
