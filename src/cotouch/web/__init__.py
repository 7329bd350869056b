"""The page in the browser: what it shows, and the server that it comes from."""
