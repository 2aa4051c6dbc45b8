# What others get: cleave::cleave, cleave::glsl and cleave::scene, by find_package(cleave) or add_subdirectory; and the
# program.

# The library cleave::<name> in one file, lib<file>, made of the objects of rooms. What the rooms are compiled with and
# see is not passed on.
function(cleave_bundle target name file)
  list(TRANSFORM ARGN REPLACE "(.+)" "$<TARGET_OBJECTS:cleave_\\1>" OUTPUT_VARIABLE objects)
  add_library(${target} ${objects})
  add_library(cleave::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES
    LINKER_LANGUAGE CXX EXPORT_NAME ${name} OUTPUT_NAME ${file}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
  target_compile_features(${target} INTERFACE cxx_std_20)
  target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/host/include>
                                                 $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${target} PUBLIC Vulkan::Headers)
  if(CLEAVE_SANITIZE)
    target_link_options(${target} PRIVATE -fsanitize=address,undefined)
  endif()
endfunction()

cleave_bundle(cleave_library cleave cleave record core)

add_library(cleave_glsl_library INTERFACE)
add_library(cleave::glsl ALIAS cleave_glsl_library)
set_target_properties(cleave_glsl_library PROPERTIES EXPORT_NAME glsl)
target_include_directories(cleave_glsl_library INTERFACE $<BUILD_INTERFACE:${cleaveGlsl}>
                                                         $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
add_dependencies(cleave_glsl_library cleave_glsl)

set(packageDir ${CMAKE_INSTALL_LIBDIR}/cmake/cleave)
install(TARGETS cleave_library cleave_glsl_library EXPORT cleaveTargets)
install(EXPORT cleaveTargets NAMESPACE cleave:: DESTINATION ${packageDir})
install(FILES host/include/cleave/cleave.hpp host/include/cleave/modes.hpp
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cleave)
install(FILES ${cleaveGlsl}/cleave.glsl ${cleaveGlsl}/cleave_ray_query.glsl DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

if(CLEAVE_SCENE)
  # It has the objects of cleave::cleave too, since it uses more of them than the public headers show.
  cleave_bundle(cleave_scene_library scene cleave_scene record core base scene tree builders judge twin gpu render run
                facade)
  target_link_libraries(cleave_scene_library PRIVATE Vulkan::Vulkan Threads::Threads TBB::tbb TinyGLTF::TinyGLTF
                                                     draco::draco meshoptimizer::meshoptimizer)
  install(TARGETS cleave_scene_library EXPORT cleaveSceneTargets)
  install(EXPORT cleaveSceneTargets NAMESPACE cleave:: DESTINATION ${packageDir})
  install(FILES host/include/cleave/scene.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cleave)
endif()

include(CMakePackageConfigHelpers)
configure_package_config_file(tools/package/cleaveConfig.cmake.in ${PROJECT_BINARY_DIR}/package/cleaveConfig.cmake
                              INSTALL_DESTINATION ${packageDir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/cleaveConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/cleaveConfig.cmake ${PROJECT_BINARY_DIR}/package/cleaveConfigVersion.cmake
        DESTINATION ${packageDir})

# Paths in cleave.pc are relative, so that the installed tree can be moved.
file(RELATIVE_PATH prefixFromPc ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(tools/package/cleave.pc.in ${PROJECT_BINARY_DIR}/package/cleave.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/cleave.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

if(CLEAVE_PROGRAM)
  install(TARGETS cleave)
  if(CLEAVE_VIEWER)
    install(TARGETS cleave-view)
  endif()
  install(FILES scenes/default.glb DESTINATION ${CMAKE_INSTALL_DATADIR}/cleave/scenes)
endif()
