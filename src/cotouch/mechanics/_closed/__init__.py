"""The closed step: where it goes, and the factor that makes its balance exact."""
