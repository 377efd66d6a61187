"""The experiments of sweeps.py on the workers of dask."""

from dask.distributed import Client
from sweeps import experiment

from passive_haptics.sweep import sweep

if __name__ == "__main__":
    # dask
    with Client() as client:  # of dask.distributed
        shares = sweep(experiment, range(300), client.get_executor(), file="dask.sweep")
    print(f"{sum(shares) / len(shares):.3f}")
