gcc -O3 -I/tmp/wt-cloud/include cloud.c -o cloud -L/tmp/wt-cloud/build/lib -lscarp -lm -Wl,-rpath,/tmp/wt-cloud/build/lib
