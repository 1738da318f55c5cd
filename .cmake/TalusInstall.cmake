# What is installed, by components: server, tools, worlds, settings; sdk is what another CMake project gets from
# find_package(talus): talus::voxel, talus::protocol, talus::client; c_api (client_sample/c_api) is libtalus.
include(CMakePackageConfigHelpers)

set(installed talus_vectors talus_voxel talus_edits talus_protocol talus_tls talus_websocket)
install(DIRECTORY core/vectors/include/ core/voxel/include/ core/edits/include/ protocol/include/ protocol/tls/include/ protocol/websocket/include/
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT sdk
  PATTERN exact_floats.h EXCLUDE PATTERN little_endian.h EXCLUDE PATTERN tables.h EXCLUDE PATTERN vectors-inl.h EXCLUDE)  # what only sources need
install(FILES ${PROJECT_BINARY_DIR}/protocol/generated/talus/protocol/talus_generated.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/talus/protocol COMPONENT sdk)
install(FILES protocol/schema/talus.fbs DESTINATION ${CMAKE_INSTALL_DATADIR}/talus COMPONENT sdk)
configure_file(.cmake/version.h.in ${PROJECT_BINARY_DIR}/include/talus/version.h @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/include/talus/version.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/talus COMPONENT sdk)
foreach(module talus_voxel talus_protocol)
  target_include_directories(${module} PUBLIC $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>)
endforeach()
if(TALUS_CLIENT)
  list(APPEND installed talus_client talus_asio)
  install(DIRECTORY client_sample/library/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT sdk)
endif()
if(TARGET talus-client)
  install(TARGETS talus-client talus-load RUNTIME COMPONENT tools)
endif()
if(TARGET talusd)
  install(TARGETS talusd RUNTIME COMPONENT server)
  install(FILES server/talusd.toml DESTINATION ${CMAKE_INSTALL_SYSCONFDIR}/talus COMPONENT settings)
  install(CODE "
    set(TALUS_DOCUMENTS OPERATIONS.md CLUSTER.md REFERENCE.md THREATS.md SECURITY.md CHANGELOG.md COMPATIBILITY.md)
    set(TALUS_SOURCES \"${PROJECT_SOURCE_DIR}/docs\")
    set(TALUS_BUILT \"${PROJECT_BINARY_DIR}/documents\")
    set(TALUS_DOCDIR \"${CMAKE_INSTALL_DOCDIR}\")" COMPONENT server)
  install(SCRIPT .cmake/install_documents.cmake COMPONENT server)
endif()
if(TARGET talus-gen)
  install(TARGETS talus-gen RUNTIME COMPONENT tools)
endif()
if(NOT TALUS_ONLY_SDK)
  install(DIRECTORY core/worlds/ DESTINATION ${CMAKE_INSTALL_DATADIR}/talus/worlds COMPONENT worlds)
endif()

install(TARGETS ${installed} EXPORT talus-targets ARCHIVE COMPONENT sdk LIBRARY COMPONENT sdk)
install(EXPORT talus-targets NAMESPACE talus:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/talus COMPONENT sdk)
configure_package_config_file(.cmake/talus-config.cmake.in ${PROJECT_BINARY_DIR}/talus-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/talus)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/talus-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/talus-config.cmake ${PROJECT_BINARY_DIR}/talus-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/talus COMPONENT sdk)
