from collections.abc import Hashable, Iterable, Mapping
from typing import Any, Self, overload

from xarray.core.dataarray import DataArray as _DataArray
from xarray.core.dataset import Dataset as _Dataset

# xarray's own, but for what it leaves without types.
class DataArray(_DataArray):
    def sel(self, indexers: Mapping[Any, Any] | None = ..., **indexers_kwargs: Any) -> Self: ...

class Dataset(_Dataset):
    @overload
    def __getitem__(self, key: Hashable) -> DataArray: ...
    @overload
    def __getitem__(self, key: Iterable[Hashable]) -> Self: ...
    def to_netcdf(
        self, path: None, *, engine: str, encoding: Mapping[Hashable, Mapping[str, object]]
    ) -> memoryview: ...
