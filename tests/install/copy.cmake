# What README's commands read, in a folder where they may leave a build/ of their own.
file(COPY ${source}/CMakeLists.txt ${source}/install.cmake ${source}/LICENSE ${source}/include DESTINATION ${copy})
