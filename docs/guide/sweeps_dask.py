"""The experiments of sweeps.py on the workers of dask."""

from dask.distributed import Client, LocalCluster
from sweeps import experiment

from passive_haptics.sweep import sweep

if __name__ == "__main__":
    # A cluster; in earnest Client("scheduler:8786")
    cluster = LocalCluster(n_workers=2, threads_per_worker=1, host="127.0.0.1", dashboard_address=None)
    with cluster, Client(cluster) as client:
        shares = sweep(experiment, range(300), client.get_executor(), file="dask.sweep")
    print(f"{sum(shares) / len(shares):.3f}")
