#!/bin/sh
#SBATCH --ntasks=16
#SBATCH --time=01:00:00

srun --mpi=pmix python -m mpi4py.futures sweeps_mpi.py
