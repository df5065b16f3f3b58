# What `cmake --install` puts where. Debian has another program named clog: installed, ours is clogflow. It finds its data
# from where it stands (coupling/base/source_folder.cpp), so the whole may be moved.
set(data ${CMAKE_INSTALL_DATADIR}/clogflow)
install(PROGRAMS $<TARGET_FILE:clog> DESTINATION ${CMAKE_INSTALL_BINDIR} RENAME clogflow)
install(DIRECTORY foam_case scenes DESTINATION ${data} USE_SOURCE_PERMISSIONS)
install(DIRECTORY postprocess/figures DESTINATION ${data}/postprocess PATTERN __pycache__ EXCLUDE)
install(DIRECTORY python DESTINATION ${data} PATTERN __pycache__ EXCLUDE PATTERN "*.egg-info" EXCLUDE)

# Pages lead to each other and to those of the rooms, so they keep their folders.
file(GLOB_RECURSE pages RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS
  docs/*.md docs/*.png docs/*.svg docs/*.csv docs/*.ipynb docs/cluster/*
  coupling/*.md dem/*.md ensemble/*.md postprocess/*.md trade/*.md foam_case/*.md scenes/*.md)
list(FILTER pages EXCLUDE REGEX "^docs/make/")
foreach(page README.md CHANGELOG.md CONTRIBUTING.md CITATION.cff LICENSE ${pages})
  get_filename_component(folder ${page} DIRECTORY)
  install(FILES ${page} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder})
endforeach()
file(GLOB_RECURSE manuals CONFIGURE_DEPENDS docs/*.1)
install(FILES ${manuals} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)

include(packaging/debian.cmake)
