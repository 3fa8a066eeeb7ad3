"""What make_book.py is made of: one subject a file."""
