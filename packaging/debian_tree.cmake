# What Debian wants of the installed files, called by cpack before it packs them: a stripped program, a packed
# changelog, a copyright file, the Python package where Debian's Python looks.
set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr)
set(pages ${root}/share/doc/clogflow)
execute_process(COMMAND strip --strip-unneeded ${root}/bin/clogflow COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${pages}/CHANGELOG.md ${pages}/changelog)
file(GLOB manuals ${root}/share/man/man1/*.1)
execute_process(COMMAND gzip -9n ${pages}/changelog ${manuals} COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${pages}/LICENSE ${pages}/copyright)
file(MAKE_DIRECTORY ${root}/lib/python3/dist-packages)
file(CREATE_LINK ../../../share/clogflow/python/clogflow ${root}/lib/python3/dist-packages/clogflow SYMBOLIC)
# Folders have the umask of whoever builds.
execute_process(COMMAND chmod -R u=rwX,go=rX ${CPACK_TEMPORARY_INSTALL_DIRECTORY} COMMAND_ERROR_IS_FATAL ANY)
