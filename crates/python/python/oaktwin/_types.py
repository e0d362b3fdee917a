"""The types of the package: names of choices, options and images. Only type checkers read them, in the stub."""
