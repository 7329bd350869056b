"""Files that people name: checked before they are opened, written whole or not at all."""

from cotouch.files._netcdf import NETCDF, write_netcdf
from cotouch.files._read import MOST_TEXT, look, read_bytes, read_text, read_toml, toml
from cotouch.files._shipped import shipped
from cotouch.files._toml import list_of, table_of, toml_text
from cotouch.files._write import beside, check_writable, folder, write

__all__ = [
    "MOST_TEXT",
    "NETCDF",
    "beside",
    "check_writable",
    "folder",
    "list_of",
    "look",
    "read_bytes",
    "read_text",
    "read_toml",
    "shipped",
    "table_of",
    "toml",
    "toml_text",
    "write",
    "write_netcdf",
]
