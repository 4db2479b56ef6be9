# What every folder's CMakeLists.txt shares: the dependencies and one way to declare a layer.

find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(EXPAT REQUIRED)
find_package(simdjson REQUIRED)
find_package(assimp CONFIG REQUIRED)
find_package(GDAL REQUIRED)
find_package(PROJ CONFIG REQUIRED)
list(APPEND CMAKE_MODULE_PATH /usr/share/cmake/geographiclib)
find_package(GeographicLib REQUIRED)
find_package(TBB CONFIG REQUIRED)
find_package(CLI11 CONFIG REQUIRED)
find_package(embree 3 CONFIG REQUIRED)
pkg_check_modules(OIIO REQUIRED IMPORTED_TARGET OpenImageIO Imath)
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_package(CGAL REQUIRED)
find_package(OpenMesh CONFIG REQUIRED)

# Interface target with the flags that all of our code is compiled with.
add_library(lodestone_flags INTERFACE)
target_include_directories(lodestone_flags INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
target_compile_options(lodestone_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
  # GCC 12 warns falsely about std::string; missing initialisers are the members' own defaults.
  -Wno-restrict -Wno-missing-field-initializers)
# The same results everywhere: no fused multiply-add, no value-changing optimisation.
target_compile_options(lodestone_flags INTERFACE -ffp-contract=off)
target_compile_definitions(lodestone_flags INTERFACE QT_NO_KEYWORDS)
if(LODESTONE_WERROR)
  target_compile_options(lodestone_flags INTERFACE -Werror)
endif()
if(LODESTONE_SANITIZE)
  target_compile_options(lodestone_flags INTERFACE -fsanitize=${LODESTONE_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(lodestone_flags INTERFACE -fsanitize=${LODESTONE_SANITIZE})
endif()

configure_file(${CMAKE_CURRENT_LIST_DIR}/version.h.in ${PROJECT_BINARY_DIR}/generated/version.h @ONLY)

# lodestone_layer(<target> [FOLDERS <folders>] LINK <targets> USES <private targets>): a static library of the .cpp files of the
# folder itself or, where some are named, of those below it.
function(lodestone_layer target)
  cmake_parse_arguments(ARG "" "" "FOLDERS;LINK;USES" ${ARGN})
  if(NOT ARG_FOLDERS)
    set(ARG_FOLDERS .)
  endif()
  set(sources)
  foreach(folder IN LISTS ARG_FOLDERS)
    file(GLOB found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.h)
    list(APPEND sources ${found})
  endforeach()
  add_library(${target} STATIC ${sources})
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(${target} PUBLIC lodestone_flags ${ARG_LINK} PRIVATE ${ARG_USES})
endfunction()
